// SPDX-License-Identifier: MIT
#include "behavior/surface/SurfaceWays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <glm/geometric.hpp>
#include <recastnavigation/DetourCommon.h>

#include "behavior/surface/SurfaceData.h"
#include "behavior/surface/SurfaceFooting.h"

namespace crowd::behavior {

namespace {

constexpr int kMostCorners = 128;
constexpr int kMostOnWay = 1024; ///< polygons
constexpr float kSearchReach[3] = {3.0F, 4.0F, 3.0F};
constexpr float kReachedMetres = 0.1F;
constexpr float kReachedShare = 0.025F; ///< of the way
constexpr float kOnLevelMetres = 1.0F;
constexpr float kOtherLevelMetres = 2.0F; ///< places may lie a little above or below their ground
constexpr float kOffEdge = 0.1F;
constexpr float kKeepsRight = 0.5F; ///< of a lane's width, of those to whose right there is room
constexpr float kLeastTurn = 0.05F; ///< of unit vectors: less is no bend

glm::vec2 flatUnit(const glm::vec3& from, const glm::vec3& to)
{
    const glm::vec2 way(to.x - from.x, to.z - from.z);
    const float length = glm::length(way);
    return length > 1e-4F ? way / length : glm::vec2(0.0F);
}

/// Corners of the shortest way, one after the other.
struct Bend
{
    glm::vec3 before;
    glm::vec3 corner;
    glm::vec3 after;
};

/// The corner of somebody's own lane: further out in the bend, where there is room for that.
/// `from`: where his lane has led him before, beside the shortest way.
glm::vec3 inLane(const SurfaceWays& surface, const glm::vec3& from, const Bend& of,
                 const Lane& lane)
{
    const glm::vec3& corner = of.corner;
    const glm::vec2 bend = flatUnit(of.before, corner) - flatUnit(corner, of.after);
    const float length = glm::length(bend);
    if (length < kLeastTurn) {
        return corner;
    }
    const glm::vec2 outwards = bend / length;
    const float share = 0.5F * (1.0F + std::clamp(glm::dot(lane.side, outwards), -1.0F, 1.0F));
    // Where both directions of a flow come by on one side, those keep further out who keep to the
    // right by that.
    const glm::vec2 ahead = flatUnit(of.before, of.after);
    const bool isRight = glm::dot(outwards, glm::vec2(-ahead.y, ahead.x)) > 0.0F;
    const glm::vec2 aside = outwards * ((share + (isRight ? kKeepsRight : 0.0F)) * lane.width);
    // From a little off the edge: on it, the ray might begin in a polygon that ends there.
    const glm::vec2 off = outwards * kOffEdge;
    const auto reached =
        surface.straight({corner.x + off.x, corner.y, corner.z + off.y},
                         {corner.x + aside.x + off.x, corner.y, corner.z + aside.y + off.y});
    // He gets there from the corner before, and on from there.
    const bool isWalkable = reached && surface.isStraight(from, *reached).value_or(false) &&
                            surface.isStraight(*reached, of.after).value_or(false);
    return isWalkable ? *reached : corner;
}

/// The corners in his own lane.
std::vector<glm::vec3> laneWay(const SurfaceWays& surface, std::span<const glm::vec3> corners,
                               const Lane& lane)
{
    std::vector<glm::vec3> way;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const bool isBend = lane.width > 0.0F && i + 1 < corners.size();
        const glm::vec3 last = way.empty() ? corners[0] : way.back();
        way.push_back(
            isBend ? inLane(surface, last, {corners[i - 1], corners[i], corners[i + 1]}, lane)
                   : corners[i]);
    }
    return way;
}

} // namespace

std::vector<glm::vec3> SurfaceWays::way(const glm::vec3& from, const glm::vec3& to,
                                        const Lane& lane) const
{
    const dtNavMeshQuery* query = m_data.query();
    if (query == nullptr) {
        return {};
    }
    const dtQueryFilter& filter = m_data.filter;
    dtPolyRef start = 0;
    dtPolyRef end = 0;
    float startPoint[3];
    float endPoint[3];
    query->findNearestPoly(&from.x, kSearchReach, &filter, &start, startPoint);
    query->findNearestPoly(&to.x, kSearchReach, &filter, &end, endPoint);
    if (start == 0 || end == 0) {
        return {};
    }
    // Whoever is sent into a wall goes to it, not to the hollow that there may be in it.
    if (m_data.ground.holds(start) && !m_data.ground.holds(end)) {
        const auto beside = SurfaceFooting(m_data).groundBeside(
            to, {kSearchReach[0], kSearchReach[1], kSearchReach[2]});
        if (beside) {
            end = beside->polygon;
            dtVcopy(endPoint, &beside->point.x);
        }
    }
    dtPolyRef polygons[kMostOnWay];
    int count = 0;
    query->findPath(start, end, startPoint, endPoint, &filter, polygons, &count, kMostOnWay);
    if (count == 0) {
        return {};
    }
    const bool isWhole = polygons[count - 1] == end;
    if (!isWhole) {
        query->closestPointOnPoly(polygons[count - 1], endPoint, endPoint, nullptr);
    }
    std::array<glm::vec3, kMostCorners> corners{};
    int cornerCount = 0;
    query->findStraightPath(startPoint, endPoint, polygons, count, &corners[0].x, nullptr, nullptr,
                            &cornerCount, kMostCorners);
    std::vector<glm::vec3> way =
        laneWay(*this, std::span(corners).first(static_cast<std::size_t>(cornerCount)), lane);
    // What lies on the surface is reached exactly.
    if (isWhole && !way.empty() &&
        glm::distance(glm::vec2(way.back().x, way.back().z), glm::vec2(to.x, to.z)) < 0.05F) {
        way.back() = {to.x, way.back().y, to.z};
    }
    return way;
}

std::optional<float> SurfaceWays::wayMetres(const glm::vec3& from, const glm::vec3& to,
                                            float within) const
{
    const auto flat = [](const glm::vec3& a, const glm::vec3& b) {
        return glm::distance(glm::vec2(a.x, a.z), glm::vec2(b.x, b.z));
    };
    const std::optional<bool> isClear = isStraight(from, to);
    if (!isClear) {
        return std::nullopt;
    }
    if (*isClear) {
        return flat(from, to); // no search, which takes far longer
    }
    float metres = 0.0F;
    glm::vec3 at = from;
    for (const glm::vec3& corner : way(from, to, Lane())) {
        metres += flat(at, corner);
        at = corner;
    }
    const bool isThere = flat(at, to) <= within && std::fabs(at.y - to.y) < kOtherLevelMetres;
    return isThere ? metres : std::numeric_limits<float>::infinity();
}

std::optional<bool> SurfaceWays::isStraight(const glm::vec3& from, const glm::vec3& to) const
{
    const auto reached = straight(from, to);
    if (!reached) {
        return std::nullopt;
    }
    // Corners lie on the very edge, which is met a little before them.
    const float left = glm::distance(glm::vec2(reached->x, reached->z), glm::vec2(to.x, to.z));
    const float length = glm::distance(glm::vec2(from.x, from.z), glm::vec2(to.x, to.z));
    return left < kReachedMetres + kReachedShare * length &&
           std::fabs(reached->y - to.y) < kOnLevelMetres;
}

std::optional<glm::vec3> SurfaceWays::straight(const glm::vec3& from, const glm::vec3& to) const
{
    constexpr float kReach[3] = {0.3F, 2.0F, 0.3F};
    constexpr float kWithinEdge = 0.98F; // of the way to it
    const dtNavMeshQuery* query = m_data.query();
    const dtQueryFilter& filter = m_data.filter;
    dtPolyRef start = 0;
    float at[3];
    if (query == nullptr || !model::Bounds::isPlace(to) ||
        dtStatusFailed(query->findNearestPoly(&from.x, kReach, &filter, &start, at)) ||
        start == 0) {
        return std::nullopt;
    }
    const float end[3] = {to.x, at[1], to.z};
    float share = 1.0F;
    float normal[3];
    dtPolyRef polygons[kMostOnWay];
    int count = 0;
    query->raycast(start, at, end, &filter, &share, normal, polygons, &count, kMostOnWay);
    share = share > 1.0F ? 1.0F : share * kWithinEdge;
    const float point[3] = {at[0] + (end[0] - at[0]) * share, at[1],
                            at[2] + (end[2] - at[2]) * share};
    float found = at[1];
    if (count > 0) {
        (void)query->getPolyHeight(polygons[count - 1], point, &found);
    }
    return glm::vec3(
        point[0], SurfaceFooting(m_data).underfoot(point[0], point[2], found - m_data.cellHeight),
        point[2]);
}

} // namespace crowd::behavior
