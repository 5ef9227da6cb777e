// SPDX-License-Identifier: MIT
#include "widgets/viewport/WaysAround.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "behavior/surface/WalkSurface.h"
#include "model/base/Segment.h"
#include "model/scene/Scene.h"

namespace crowd::widgets {

namespace {

constexpr float kAsideMetres = 0.5F; ///< what is nearer to the straight line is straight on
constexpr float kShortestStep = 0.05F;
constexpr float kEdge = 0.8F; ///< of the flow's half width: some walk there, in most crowds

glm::vec3 level(const glm::vec3& point)
{
    return {point.x, 0.0F, point.z};
}

/// How far what is farthest aside lies from the straight line; metres, negative to its left.
float farthestAside(const WayCorners& way, const glm::vec3& from, const glm::vec3& to)
{
    const glm::vec3 along = level(to - from);
    float farthest = 0.0F;
    for (const glm::vec3& corner : way) {
        const float share = model::nearestShare(level(corner), level(from), level(to));
        const glm::vec3 aside = level(corner) - glm::mix(level(from), level(to), share);
        const float metres = glm::length(aside);
        if (metres > std::abs(farthest)) {
            farthest = along.x * aside.z - along.z * aside.x < 0.0F ? -metres : metres;
        }
    }
    return farthest;
}

/// 0: straight on.
int sideOf(float farthest)
{
    if (std::abs(farthest) <= kAsideMetres) {
        return 0;
    }
    return farthest < 0.0F ? -1 : 1;
}

struct Flow
{
    const behavior::WalkSurface& surface;
    const model::Place& from;
    const model::Place& to;
    glm::vec3 across; ///< of length 1, level

    /// As somebody takes it who walks so far aside in the flow (-1..1).
    [[nodiscard]] WayCorners way(float aside, int& side) const
    {
        const glm::vec3 start = pointIn(from, aside);
        const glm::vec3 end = pointIn(to, aside);
        WayCorners corners = surface.way(start, end, behavior::Lane());
        side = corners.empty() ? 0 : sideOf(farthestAside(corners, start, end));
        if (!corners.empty() && glm::length(level(corners.front() - start)) > kShortestStep) {
            corners.insert(corners.begin(), start);
        }
        return corners;
    }
    /// Where somebody is in a place, as far aside as one can go in it.
    [[nodiscard]] glm::vec3 pointIn(const model::Place& place, float aside) const
    {
        const glm::vec3 point = place.position + across * (aside * place.radius);
        return aside == 0.0F ? point : surface.straight(place.position, point).value_or(point);
    }
};

} // namespace

std::vector<WayCorners> waysAround(const behavior::WalkSurface* surface, const model::Place& from,
                                   const model::Place& to)
{
    const glm::vec3 along = level(to.position - from.position);
    if (surface == nullptr || glm::length(along) < kShortestStep) {
        return {};
    }
    const glm::vec3 step = glm::normalize(along);
    const Flow flow{*surface, from, to, {-step.z, 0.0F, step.x}};
    std::vector<WayCorners> ways;
    int middle = 0;
    ways.push_back(flow.way(0.0F, middle));
    if (middle == 0) {
        return {};
    }
    // If any pass by on the other side, then those at the edge over there, perhaps straight on.
    int side = 0;
    WayCorners other = flow.way(middle < 0 ? kEdge : -kEdge, side);
    if (!other.empty() && side != middle) {
        ways.push_back(std::move(other));
    }
    return ways;
}

} // namespace crowd::widgets
