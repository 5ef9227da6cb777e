// SPDX-License-Identifier: MIT
#include "widgets/tools/PlaceHits.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QtCore/QLineF>

#include "model/scene/PlaceShape.h"

namespace crowd::widgets {

namespace {

constexpr int kSides = 40;
constexpr double kMiddlePixels = 9.0;
constexpr double kBorderPixels = 5.0;
constexpr float kLeastUpright = 0.5F; ///< of a surface's normal: steeper is a wall
constexpr double kCornerPixels = 8.0;
constexpr double kSidePixels = 5.0;

/// Pixels from one to the nearest of a straight side.
double distanceToSide(const QPointF& pixel, const QPointF& from, const QPointF& to)
{
    const QPointF along = to - from;
    const double square = QPointF::dotProduct(along, along);
    const double share =
        square > 0.0 ? std::clamp(QPointF::dotProduct(pixel - from, along) / square, 0.0, 1.0)
                     : 0.0;
    return QLineF(pixel, from + along * share).length();
}

double distanceTo(const QPolygonF& outline, const QPointF& pixel)
{
    double nearest = 1e9;
    for (int i = 0; i + 1 < outline.size(); ++i) {
        nearest = std::min(nearest, distanceToSide(pixel, outline[i], outline[i + 1]));
    }
    return nearest;
}

/// How wide a line is where it begins, from its middle, pixels.
double halfPixels(const model::View& view, const model::Place& place, const glm::vec3& corner)
{
    const auto middle = view.project(corner);
    const auto aside = view.project(corner + glm::vec3(place.radius, 0.0F, 0.0F));
    return middle && aside && place.shape == model::PlaceShape::Line
               ? QLineF(QPointF(middle->x, middle->y), QPointF(aside->x, aside->y)).length()
               : 0.0;
}

/// A corner of this place under a pixel, or one of its sides (no corner). Nothing of a round one.
std::optional<PlaceHit> shapeAt(const model::View& view, const model::Place& place,
                                const QPointF& pixel)
{
    if (place.shape == model::PlaceShape::Round) {
        return std::nullopt;
    }
    const std::vector<glm::vec3> corners = model::cornersOf(place);
    std::vector<std::optional<QPointF>> pixels;
    pixels.reserve(corners.size());
    for (const glm::vec3& corner : corners) {
        const auto at = view.project(corner);
        pixels.push_back(at ? std::optional(QPointF(at->x, at->y)) : std::nullopt);
    }
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (pixels[i] && QLineF(pixel, *pixels[i]).length() < kCornerPixels) {
            return PlaceHit{place.id, false, i};
        }
    }
    for (std::size_t i = 0; i < sidesOf(place); ++i) {
        const auto& from = pixels[i];
        const auto& to = pixels[(i + 1) % pixels.size()];
        if (from && to &&
            distanceToSide(pixel, *from, *to) <
                std::max(kSidePixels, halfPixels(view, place, corners[i]))) {
            return PlaceHit{place.id, false, std::nullopt};
        }
    }
    return std::nullopt;
}

} // namespace

QPolygonF placeOutline(const model::View& view, const glm::vec3& position, float radius)
{
    QPolygonF outline;
    for (int i = 0; i <= kSides; ++i) {
        const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(kSides);
        const auto pixel =
            view.project(position + radius * glm::vec3(std::sin(angle), 0.0F, std::cos(angle)));
        if (!pixel) {
            return {};
        }
        outline << QPointF(pixel->x, pixel->y);
    }
    return outline;
}

std::optional<PlaceHit> placeAt(const ToolContext& context, const QPointF& pixel)
{
    if (!context.state.viewOptions().showPaths) {
        return std::nullopt;
    }
    const model::View view = context.queries.view();
    std::optional<PlaceHit> border;
    double nearest = kMiddlePixels;
    std::optional<PlaceHit> middle;
    std::optional<PlaceHit> corner;
    for (const model::Place& place : context.state.scene().places) {
        const auto center = view.project(place.position);
        if (!center) {
            continue;
        }
        const double away = QLineF(pixel, QPointF(center->x, center->y)).length();
        if (away < nearest) {
            nearest = away;
            middle = PlaceHit{place.id};
        }
        const auto shape = shapeAt(view, place, pixel);
        if (shape && shape->corner) {
            corner = shape;
        } else if (!border && shape) {
            border = shape;
        } else if (!border && place.shape == model::PlaceShape::Round &&
                   distanceTo(placeOutline(view, place.position, place.radius), pixel) <
                       kBorderPixels) {
            border = PlaceHit{place.id, true};
        }
    }
    return corner ? corner : middle ? middle : border;
}

std::size_t sidesOf(const model::Place& place)
{
    return place.shape == model::PlaceShape::Area ? place.corners.size() : place.corners.size() - 1;
}

std::optional<glm::vec3> groundUnder(const ToolContext& context, const ToolInput& input)
{
    const auto hit =
        context.queries.picker(input.pointer.shownSeconds).surfaceAt(input.pointer.pixels());
    const bool isGround = hit && hit->normal.y > kLeastUpright;
    return isGround ? std::optional<glm::vec3>(hit->point) : std::nullopt;
}

} // namespace crowd::widgets
