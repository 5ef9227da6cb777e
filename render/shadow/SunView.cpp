// SPDX-License-Identifier: MIT
#include "render/shadow/SunView.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

namespace crowd::render {

glm::vec3 cornerOf(const model::Bounds& box, unsigned corner)
{
    return {(corner & 1U) != 0 ? box.high.x : box.low.x,
            (corner & 2U) != 0 ? box.high.y : box.low.y,
            (corner & 4U) != 0 ? box.high.z : box.low.z};
}

namespace {

/// From what is seen, towards the sun and away from it, to what casts and receives beside it.
constexpr float kFarthestMetres = 400.0F;
constexpr float kFarMetres = 3000.0F; ///< of an orthographic model::View, both ways
using Polygon = std::vector<glm::vec3>;

/// The camera's frustum: planes whose inside is positive, and corners.
struct Frustum
{
    std::array<glm::vec4, 6> planes{};
    std::array<glm::vec3, 8> corners{};
};

glm::vec3 unprojected(const glm::mat4& inverse, const glm::vec3& clip)
{
    const glm::vec4 point = inverse * glm::vec4(clip, 1.0F);
    return glm::vec3(point) / point.w;
}

Frustum frustumOf(const model::View& view, float farMetres)
{
    Frustum frustum;
    const glm::mat4 m = glm::transpose(view.viewProjection());
    const model::Camera& camera = view.camera();
    const glm::vec3 forward = camera.forward();
    const float at = glm::dot(forward, camera.position);
    const bool isFlat = camera.projection == model::Projection::Orthographic;
    frustum.planes = {m[3] + m[0], m[3] - m[0],
                      m[3] + m[1], m[3] - m[1],
                      m[3] + m[2], isFlat ? m[3] - m[2] : glm::vec4(-forward, at + farMetres)};
    const glm::mat4 inverse = glm::inverse(view.viewProjection());
    for (std::size_t i = 0; i < frustum.corners.size(); ++i) {
        const float x = (i & 1U) != 0 ? 1.0F : -1.0F;
        const float y = (i & 2U) != 0 ? 1.0F : -1.0F;
        const glm::vec3 front = unprojected(inverse, {x, y, -1.0F});
        const glm::vec3 back = unprojected(inverse, {x, y, 1.0F});
        const float from = glm::dot(forward, front) - at;
        const float to = glm::dot(forward, back) - at;
        const float share = isFlat ? 1.0F : std::min(1.0F, (farMetres - from) / (to - from));
        frustum.corners[i] = (i & 4U) != 0 ? glm::mix(front, back, share) : front;
    }
    return frustum;
}

/// Sutherland and Hodgman, "Reentrant polygon clipping", 1974.
Polygon clipped(const Polygon& polygon, const glm::vec4& plane)
{
    Polygon inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::vec3& here = polygon[i];
        const glm::vec3& next = polygon[(i + 1) % polygon.size()];
        const float a = glm::dot(plane, glm::vec4(here, 1.0F));
        const float b = glm::dot(plane, glm::vec4(next, 1.0F));
        if (a >= 0.0F) {
            inside.push_back(here);
        }
        if ((a >= 0.0F) != (b >= 0.0F)) {
            inside.push_back(glm::mix(here, next, a / (a - b)));
        }
    }
    return inside;
}

bool isInside(const model::Bounds& box, const glm::vec3& point)
{
    return glm::all(glm::greaterThanEqual(point, box.low)) &&
           glm::all(glm::lessThanEqual(point, box.high));
}

/// The corners of what a frustum and a box have in common: those of the box's sides as they are
/// seen, and those of the frustum that lie in the box.
Polygon cornersOfCommon(const Frustum& frustum, const model::Bounds& box)
{
    constexpr std::array<std::array<unsigned, 4>, 6> kSides{
        {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};
    Polygon common;
    for (const auto& side : kSides) {
        Polygon polygon;
        for (const unsigned corner : side) {
            polygon.push_back(cornerOf(box, corner));
        }
        for (const glm::vec4& plane : frustum.planes) {
            polygon = clipped(polygon, plane);
        }
        common.insert(common.end(), polygon.begin(), polygon.end());
    }
    std::ranges::copy_if(frustum.corners, std::back_inserter(common),
                         [&box](const glm::vec3& corner) { return isInside(box, corner); });
    return common;
}

/// A little more than needed, in coarse steps: the size changes seldom.
float stepped(float metres)
{
    constexpr float kStepsPerDoubling = 4.0F;
    return std::exp2(std::ceil(std::log2(std::max(metres, 1.0F)) * kStepsPerDoubling) /
                     kStepsPerDoubling);
}

/// From a view's depth to one that runs from what receives shadows to what casts them on it, so
/// that few bits are enough. Heights: metres towards the sun.
glm::mat4 depthOf(float lowest, float highest, float sunHeight)
{
    constexpr float kRoom = 1.0F; // metres
    const float middle = (lowest + highest) * 0.5F - sunHeight;
    const float half = (highest - lowest) * 0.5F + kRoom;
    // An orthographic view's depth runs from -1 so far towards the sun to 1 so far behind.
    glm::mat4 depth(1.0F);
    depth[2][2] = kFarMetres / half;
    depth[3][2] = middle / half;
    return depth;
}

/// Lowest and highest of a box, towards the sun.
glm::vec2 heightsOf(const model::Bounds& scene, const glm::vec3& toSun)
{
    glm::vec2 heights(std::numeric_limits<float>::infinity(),
                      -std::numeric_limits<float>::infinity());
    for (unsigned corner = 0; corner < 8; ++corner) {
        const float height = glm::dot(toSun, cornerOf(scene, corner));
        heights = {std::min(heights.x, height), std::max(heights.y, height)};
    }
    return heights;
}

} // namespace

std::optional<SunView> fitSunView(const model::View& camera, float farMetres,
                                  const model::Bounds& seen, const glm::vec3& toSun, int mapPixels)
{
    const Polygon points =
        seen.isEmpty() ? Polygon() : cornersOfCommon(frustumOf(camera, farMetres), seen);
    if (points.empty()) {
        return std::nullopt;
    }
    model::Camera sun = model::Camera::lookingAt(glm::vec3(0.0F), -toSun);
    model::Bounds across; // in the sun's own axes
    for (const glm::vec3& point : points) {
        across.add(
            {glm::dot(sun.right(), point), glm::dot(sun.up(), point), glm::dot(toSun, point)});
    }
    // Room for the steps that the middle is moved in.
    constexpr float kRoom = 1.02F;
    const glm::vec2 metres(stepped(across.size().x * kRoom), stepped(across.size().y * kRoom));
    const glm::vec2 texel = metres / static_cast<float>(mapPixels);
    const glm::vec2 middle = glm::floor(glm::vec2(across.center()) / texel) * texel;
    sun.position = sun.right() * middle.x + sun.up() * middle.y + toSun * across.center().z;
    sun.projection = model::Projection::Orthographic;
    sun.orthographicHeight = metres.y;
    const float longest = std::max(texel.x, texel.y);
    const model::View view(sun, metres / longest);
    // Somebody at the end of the world casts nothing here, and receives nothing.
    const glm::vec2 heights = heightsOf(seen, toSun);
    const float lowest = std::max(heights.x, across.low.z - kFarthestMetres);
    const float highest = std::min(heights.y, across.high.z + kFarthestMetres);
    const glm::mat4 clip = depthOf(lowest, highest, across.center().z) * view.viewProjection();
    const glm::mat4 half =
        glm::scale(glm::translate(glm::mat4(1.0F), glm::vec3(0.5F)), glm::vec3(0.5F));
    return SunView{view, longest, metres, clip, half * clip};
}

} // namespace crowd::render
