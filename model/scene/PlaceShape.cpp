// SPDX-License-Identifier: MIT
#include "model/scene/PlaceShape.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/Bounds.h"
#include "model/base/Segment.h"

namespace crowd::model {

namespace {

constexpr std::size_t kCornersOfLine = 2;
constexpr std::size_t kCornersOfArea = 3;

glm::vec2 flat(const glm::vec3& point)
{
    return {point.x, point.z};
}

glm::vec2 nearestOn(glm::vec2 from, glm::vec2 to, glm::vec2 at)
{
    const float share = nearestShare({at, 0.0F}, {from, 0.0F}, {to, 0.0F});
    return glm::mix(from, to, share);
}

/// Of a line from corner to corner, closed where it is the border of an area.
glm::vec2 nearestOn(std::span<const glm::vec3> corners, bool isClosed, glm::vec2 at)
{
    glm::vec2 nearest = flat(corners.front());
    const std::size_t sides = isClosed ? corners.size() : corners.size() - 1;
    for (std::size_t i = 0; i < sides; ++i) {
        const glm::vec2 on =
            nearestOn(flat(corners[i]), flat(corners[(i + 1) % corners.size()]), at);
        if (glm::distance(on, at) < glm::distance(nearest, at)) {
            nearest = on;
        }
    }
    return nearest;
}

float flatDistance(const glm::vec3& a, const glm::vec3& b)
{
    return glm::distance(flat(a), flat(b));
}

float lengthOf(std::span<const glm::vec3> corners, bool isClosed)
{
    float metres = isClosed ? flatDistance(corners.back(), corners.front()) : 0.0F;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        metres += flatDistance(corners[i], corners[i + 1]);
    }
    return metres;
}

float enclosedArea(std::span<const glm::vec3> corners)
{
    float twice = 0.0F;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec2 a = flat(corners[i] - corners.front());
        const glm::vec2 b = flat(corners[(i + 1) % corners.size()] - corners.front());
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5F * std::abs(twice);
}

/// The middle of the widest of what the area has at a height.
glm::vec3 middleAt(std::span<const glm::vec3> corners, const glm::vec3& middle)
{
    std::vector<float> crossings;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3& a = corners[i];
        const glm::vec3& b = corners[(i + 1) % corners.size()];
        if ((a.z > middle.z) != (b.z > middle.z)) {
            crossings.push_back(a.x + (b.x - a.x) * (middle.z - a.z) / (b.z - a.z));
        }
    }
    std::ranges::sort(crossings);
    float widest = 0.0F;
    float x = corners.front().x;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        if (crossings[i + 1] - crossings[i] > widest) {
            widest = crossings[i + 1] - crossings[i];
            x = 0.5F * (crossings[i] + crossings[i + 1]);
        }
    }
    return {x, middle.y, middle.z};
}

/// Where the bounds of an area have their middle, if that is in it; else beside that.
glm::vec3 middleOfArea(std::span<const glm::vec3> corners)
{
    Bounds bounds;
    for (const glm::vec3& corner : corners) {
        bounds.add(corner);
    }
    const glm::vec3 middle = bounds.center();
    return isEnclosed(corners, flat(middle)) ? middle : middleAt(corners, middle);
}

/// Halfway along it.
glm::vec3 middleOfLine(std::span<const glm::vec3> corners)
{
    float left = 0.5F * lengthOf(corners, false);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const float side = flatDistance(corners[i], corners[i + 1]);
        if (left <= side && side > 0.0F) {
            return glm::mix(corners[i], corners[i + 1], left / side);
        }
        left -= side;
    }
    return corners.back();
}

} // namespace

std::vector<glm::vec3> cornersOf(const Place& place)
{
    std::vector<glm::vec3> corners;
    if (place.shape != PlaceShape::Round) {
        corners.reserve(place.corners.size());
        for (const glm::vec3& corner : place.corners) {
            corners.push_back(place.position + corner);
        }
    }
    return corners;
}

glm::vec2 nearestOf(const Place& place, glm::vec2 at)
{
    const glm::vec2 middle = flat(place.position);
    if (place.shape == PlaceShape::Round || place.corners.empty()) {
        return middle;
    }
    const glm::vec2 from = at - middle;
    const bool isArea = place.shape == PlaceShape::Area;
    if (isArea && isEnclosed(place.corners, from)) {
        return at;
    }
    return middle + nearestOn(place.corners, isArea, from);
}

bool isWithin(const Place& place, const glm::vec3& at)
{
    const glm::vec2 nearest = nearestOf(place, flat(at));
    const float x = nearest.x - at.x;
    const float z = nearest.y - at.z;
    return std::sqrt(x * x + z * z) <= place.radius;
}

bool isEnclosed(std::span<const glm::vec3> corners, glm::vec2 at)
{
    bool isIn = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec2 a = flat(corners[i]);
        const glm::vec2 b = flat(corners[(i + 1) % corners.size()]);
        if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y)) {
            isIn = !isIn;
        }
    }
    return isIn;
}

float reachOf(const Place& place)
{
    float farthest = 0.0F;
    for (const glm::vec3& corner : place.corners) {
        farthest = std::max(farthest, glm::length(flat(corner)));
    }
    return place.radius + (place.shape == PlaceShape::Round ? 0.0F : farthest);
}

float lengthOf(const Place& place)
{
    return place.shape == PlaceShape::Round || place.corners.empty()
               ? 0.0F
               : lengthOf(place.corners, place.shape == PlaceShape::Area);
}

float areaOf(const Place& place)
{
    const float disc = 3.14159265F * place.radius * place.radius;
    if (place.shape == PlaceShape::Round || place.corners.empty()) {
        return disc;
    }
    const bool isArea = place.shape == PlaceShape::Area;
    const float sides = lengthOf(place.corners, isArea) * place.radius;
    return disc + (isArea ? sides + enclosedArea(place.corners) : 2.0F * sides);
}

std::uint32_t roomOf(const Place& place)
{
    constexpr float kPeoplePerSquareMetre = 2.0F;
    const float people = kPeoplePerSquareMetre * areaOf(place);
    return place.capacity != 0 ? place.capacity
                               : static_cast<std::uint32_t>(std::clamp(
                                     people, 1.0F, static_cast<float>(kMaxPlaceCapacity)));
}

void setCorners(Place& place, std::span<const glm::vec3> corners)
{
    place.position =
        place.shape == PlaceShape::Area ? middleOfArea(corners) : middleOfLine(corners);
    place.corners.clear();
    place.corners.reserve(corners.size());
    for (const glm::vec3& corner : corners) {
        place.corners.push_back(corner - place.position);
    }
}

bool isWhole(const Place& place)
{
    const std::size_t least = place.shape == PlaceShape::Round  ? 0
                              : place.shape == PlaceShape::Line ? kCornersOfLine
                                                                : kCornersOfArea;
    return place.corners.size() >= least && place.corners.size() <= kMostCorners &&
           std::ranges::all_of(place.corners, [](const glm::vec3& corner) {
               const glm::vec3 away = glm::abs(corner);
               return away.x <= kFarthestCorner && away.y <= kFarthestCorner &&
                      away.z <= kFarthestCorner;
           });
}

} // namespace crowd::model
