// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/Tool.h"

/// Lines and areas under the hand of the environment brush. Each click is one undo step, so is what
/// was drawn freely.
namespace crowd::widgets {

/// A press: a click adds a corner to the place that is being drawn (see PathFocus::shaped), or
/// begins another one; on its first corner it closes it, a second one ends it. A drag draws freely.
[[nodiscard]] DragSessionPtr shapeDrag(const ToolContext& context, const ToolInput& press);
/// The side that a click would add.
void showShapeToCome(const ToolContext& context, const ToolInput& input, ToolPicture& picture);

} // namespace crowd::widgets
