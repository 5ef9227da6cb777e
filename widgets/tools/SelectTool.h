// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/Tool.h"

namespace crowd::widgets {

/// Click selects, Shift adds, Control toggles; dragging from empty ground draws a rectangle or a
/// lasso;
/// dragging somebody moves all that are selected, on the ground or to free seats.
class SelectTool : public Tool
{
public:
    explicit SelectTool(const ToolContext& context) : m_context(context) {}

    [[nodiscard]] QString hint() const override;
    [[nodiscard]] DragSessionPtr press(const ToolInput& input) override;
    void hover(const ToolInput& input, ToolPicture& picture) const override;
    void preview(const ToolInput& input, ToolPicture& picture) const override;

private:
    ToolContext m_context;
};

/// The mode that modifiers ask for.
[[nodiscard]] SelectionMode selectionModeFor(Qt::KeyboardModifiers modifiers);

} // namespace crowd::widgets
