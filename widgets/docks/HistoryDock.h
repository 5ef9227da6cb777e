// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QLabel;

namespace crowd::widgets {

/// All undo steps; a click goes there. Below them, what keeping them takes.
class HistoryDock : public DockBase
{
    Q_OBJECT

public:
    HistoryDock(EditorState& state, QWidget* parent);

private:
    void showMemory();

    const model::SceneDocument& m_document;
    QLabel* m_memory;
};

} // namespace crowd::widgets
