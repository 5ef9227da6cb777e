// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/PlaceHits.h"

/// Corners of places that are lines or areas, as something to take hold of in the picture.
namespace crowd::widgets {

/// Dragging moves the corner that was hit, with `press` on it.
[[nodiscard]] DragSessionPtr cornerDrag(const ToolContext& context, const ToolInput& press,
                                        const PlaceHit& hit);
/// A double click: the corner that was hit goes, or another one comes where a side was hit. False:
/// the place is round.
bool changeCorners(const ToolContext& context, const ToolInput& input, const PlaceHit& hit);

} // namespace crowd::widgets
