// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include <QtCore/QPointF>
#include <QtGui/QPolygonF>

#include "widgets/tools/Tool.h"

/// What of places and of the ground is under the pointer.
namespace crowd::widgets {

/// What of a place is under the pointer.
struct PlaceHit
{
    model::PlaceId place = 0;
    bool isBorder = false;                            ///< its circle: dragging it changes the size
    std::optional<std::size_t> corner = std::nullopt; ///< of a line or an area
};

/// The circle of a place on screen, closed; empty where it is behind the camera.
[[nodiscard]] QPolygonF placeOutline(const model::View& view, const glm::vec3& position,
                                     float radius);
/// The place whose middle, corner, side or circle is under a pixel; middles and corners first.
[[nodiscard]] std::optional<PlaceHit> placeAt(const ToolContext& context, const QPointF& pixel);
/// Of a line or an area.
[[nodiscard]] std::size_t sidesOf(const model::Place& place);
/// Stage or ground under the pointer.
[[nodiscard]] std::optional<glm::vec3> groundUnder(const ToolContext& context,
                                                   const ToolInput& input);

} // namespace crowd::widgets
