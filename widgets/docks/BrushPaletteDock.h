// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QToolButton;

namespace crowd::widgets {

/// The tools as large buttons.
class BrushPaletteDock : public DockBase
{
    Q_OBJECT

public:
    BrushPaletteDock(EditorState& state, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void refreshIcons();

    EditorState& m_state;
    std::array<QToolButton*, static_cast<std::size_t>(ToolId::Count)> m_buttons{};
};

} // namespace crowd::widgets
