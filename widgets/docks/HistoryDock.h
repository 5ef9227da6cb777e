// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// All undo steps; a click goes there.
class HistoryDock : public DockBase
{
    Q_OBJECT

public:
    HistoryDock(EditorState& state, QWidget* parent);
};

} // namespace crowd::widgets
