// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "widgets/tools/PlaceHandles.h"

/// Corners of places that are lines or areas, as something to take hold of in the picture.
namespace crowd::widgets {

/// Pixels from one to the nearest of a straight side.
[[nodiscard]] double distanceToSide(const QPointF& pixel, const QPointF& from, const QPointF& to);
/// A corner of this place under a pixel, or one of its sides (no corner). Nothing of a round one.
[[nodiscard]] std::optional<PlaceHit> shapeAt(const model::View& view, const model::Place& place,
                                              const QPointF& pixel);
/// Dragging moves the corner that was hit, with `press` on it.
[[nodiscard]] DragSessionPtr cornerDrag(const ToolContext& context, const ToolInput& press,
                                        const PlaceHit& hit);
/// A double click: the corner that was hit goes, or another one comes where a side was hit. False:
/// the place is round.
bool changeCorners(const ToolContext& context, const ToolInput& input, const PlaceHit& hit);

} // namespace crowd::widgets
