// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/PlaceHandles.h"
#include "widgets/tools/Tool.h"

namespace crowd::widgets {

/// The path brush and the environment brush: each click sets a place of the brush's size on the
/// ground, a drag one after the other; each place is one undo step. The path brush extends the
/// current path; a click on its first place closes it.
class PlaceTool : public Tool
{
public:
    PlaceTool(const ToolContext& context, model::BrushKind kind);

    [[nodiscard]] QString hint() const override;
    [[nodiscard]] DragSessionPtr press(const ToolInput& input) override;
    void hover(const ToolInput& input, ToolPicture& picture) const override;

private:
    ToolContext m_context;
    model::BrushKind m_kind;
};

} // namespace crowd::widgets
