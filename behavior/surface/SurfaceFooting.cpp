// SPDX-License-Identifier: MIT
#include "behavior/surface/SurfaceFooting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "behavior/surface/SurfaceData.h"

namespace crowd::behavior {

namespace {

static_assert(sizeof(dtPolyRef) <= sizeof(std::uint32_t));

constexpr float kFootingReach[3] = {0.3F, 2.0F, 0.3F}; ///< to a surface from beside it
constexpr float kJumpMetres = 1.0F;                    ///< further away somebody was put elsewhere
constexpr int kMostVisited = 48;                       ///< polygons in one step
constexpr float kUprightCosine = 0.5F;                 ///< steeper is nothing that feet stand on
constexpr float kMeshError = 0.15F;                    ///< of the surface's height, metres
constexpr float kBesideMetres = 0.2F; ///< edges are found no finer than the cells of the building
constexpr float kNearEdge = 0.5F;     ///< metres, beside a body: so near to what can be walked on
constexpr float kOpenGround = 0.1F;   ///< height that counts as the plane y = 0
constexpr float kBorderMetres = 1.0F; ///< the surface ends a little before its bounds

float squaredAway(const float* a, const glm::vec3& b)
{
    const float x = a[0] - b.x;
    const float z = a[2] - b.z;
    return x * x + z * z;
}

/// The nearest point of the ground, as seen from above; then the nearest height.
class NearestGround : public dtPolyQuery
{
public:
    NearestGround(const dtNavMeshQuery& query, const SurfaceData& data, const glm::vec3& from)
        : m_query(query), m_data(data), m_from(from)
    {
    }
    void process(const dtMeshTile* /*tile*/, dtPoly** /*polys*/, dtPolyRef* refs,
                 int count) override
    {
        for (int i = 0; i < count; ++i) {
            float closest[3];
            bool isOver = false;
            if (!m_data.ground.holds(refs[i]) ||
                dtStatusFailed(m_query.closestPointOnPoly(refs[i], &m_from.x, closest, &isOver))) {
                continue;
            }
            // Over it: straight up or down, however far.
            const float flat = isOver ? 0.0F : squaredAway(closest, m_from);
            const float height = std::fabs(closest[1] - m_from.y);
            if (flat < m_flat || (flat == m_flat && height < m_height)) {
                m_polygon = refs[i];
                m_flat = flat;
                m_height = height;
                m_point = isOver ? glm::vec3(m_from.x, closest[1], m_from.z)
                                 : glm::vec3(closest[0], closest[1], closest[2]);
            }
        }
    }
    [[nodiscard]] bool isFound() const { return m_polygon != 0; }
    [[nodiscard]] dtPolyRef polygon() const { return m_polygon; }
    [[nodiscard]] const glm::vec3& point() const { return m_point; }
    [[nodiscard]] float flatSquared() const { return m_flat; }

private:
    const dtNavMeshQuery& m_query;
    const SurfaceData& m_data;
    glm::vec3 m_from;
    dtPolyRef m_polygon = 0;
    glm::vec3 m_point{0.0F};
    float m_flat = std::numeric_limits<float>::infinity();
    float m_height = std::numeric_limits<float>::infinity();
};

/// Whether the plane y = 0 goes on there, beyond all stages.
bool isBeyond(const model::Bounds& covered, const glm::vec3& point)
{
    return point.x < covered.low.x + kBorderMetres || point.x > covered.high.x - kBorderMetres ||
           point.z < covered.low.z + kBorderMetres || point.z > covered.high.z - kBorderMetres;
}

} // namespace

float SurfaceFooting::underfoot(float x, float z, float surfaceHeight) const
{
    const float step = m_data.climb + kMeshError;
    const model::Ray down{{x, surfaceHeight + step, z}, {0.0F, -1.0F, 0.0F}};
    const auto hit = m_data.rays.hit(down, 2.0F * step);
    return hit && hit->normal.y > kUprightCosine ? hit->point.y : surfaceHeight;
}

float SurfaceFooting::height(float x, float z, float near) const
{
    Footing footing;
    return follow(footing, {x, near, z}) ? underfoot(x, z, footing.point.y) : near;
}

bool SurfaceFooting::follow(Footing& footing, const glm::vec3& feet) const
{
    const dtNavMeshQuery* query = m_data.query();
    if (query == nullptr) {
        return false;
    }
    const dtQueryFilter& filter = m_data.everything;
    float point[3];
    dtPolyRef polygon = 0;
    if (footing.polygon != 0) {
        dtPolyRef visited[kMostVisited];
        int count = 0;
        const bool isDone =
            dtStatusSucceed(query->moveAlongSurface(footing.polygon, &footing.point.x, &feet.x,
                                                    &filter, point, visited, &count, kMostVisited));
        const bool isThere = isDone && count > 0 && count < kMostVisited &&
                             squaredAway(point, feet) < kJumpMetres * kJumpMetres;
        polygon = isThere ? visited[count - 1] : 0;
    }
    if (polygon == 0 &&
        (dtStatusFailed(query->findNearestPoly(&feet.x, kFootingReach, &filter, &polygon, point)) ||
         squaredAway(point, feet) > kFootingReach[0] * kFootingReach[0])) {
        polygon = 0; // what it finds may be as far away as the polygon is large
    }
    footing.polygon = static_cast<std::uint32_t>(polygon);
    if (polygon == 0) {
        return false;
    }
    float height = point[1];
    (void)query->getPolyHeight(polygon, point, &height);
    // Recast lays its surface a cell's height above what it was made from.
    footing.point = {point[0], height - m_data.cellHeight, point[2]};
    return true;
}

bool SurfaceFooting::isWalkable(const glm::vec3& point) const
{
    const dtNavMeshQuery* query = m_data.query();
    if (query == nullptr || isBeyond(m_data.covered, point)) {
        return query == nullptr || std::fabs(point.y) < kOpenGround;
    }
    const float reach[3] = {kBesideMetres, m_data.climb + kMeshError, kBesideMetres};
    NearestGround search(*query, m_data, point);
    return dtStatusSucceed(query->queryPolygons(&point.x, reach, &m_data.everything, &search)) &&
           search.isFound() && search.flatSquared() <= kBesideMetres * kBesideMetres &&
           std::fabs(search.point().y - point.y) <= reach[1];
}

std::optional<glm::vec3> SurfaceFooting::nearest(const glm::vec3& point) const
{
    if (isWalkable(point)) {
        return point;
    }
    if (isBeyond(m_data.covered, point)) {
        return glm::vec3(point.x, 0.0F, point.z);
    }
    const dtNavMeshQuery* query = m_data.query();
    const model::Bounds& covered = m_data.covered;
    const float tall =
        std::max(std::fabs(point.y - covered.low.y), std::fabs(covered.high.y - point.y));
    // Only what lies within the circle is the nearest for sure; the box reaches further.
    for (const float metres : {4.0F, 32.0F, 256.0F}) {
        const float reach[3] = {metres, tall, metres};
        NearestGround search(*query, m_data, point);
        if (dtStatusSucceed(query->queryPolygons(&point.x, reach, &m_data.everything, &search)) &&
            search.isFound() && search.flatSquared() <= metres * metres) {
            const glm::vec3 found = search.point();
            return glm::vec3(found.x, underfoot(found.x, found.z, found.y - m_data.cellHeight),
                             found.z);
        }
    }
    return std::nullopt;
}

std::optional<GroundPoint> SurfaceFooting::groundBeside(const glm::vec3& point,
                                                        const glm::vec3& reach) const
{
    const dtNavMeshQuery* query = m_data.query();
    if (query == nullptr) {
        return std::nullopt;
    }
    NearestGround search(*query, m_data, point);
    if (dtStatusFailed(query->queryPolygons(&point.x, &reach.x, &m_data.filter, &search)) ||
        !search.isFound() || search.flatSquared() > reach.x * reach.x) {
        return std::nullopt;
    }
    return GroundPoint{search.polygon(), search.point()};
}

model::WalkRefusal SurfaceFooting::refusal(const glm::vec3& point) const
{
    using model::WalkRefusal;
    if (isWalkable(point)) {
        return WalkRefusal::None;
    }
    const float step = m_data.climb + kMeshError;
    const auto under =
        m_data.rays.hit({point + glm::vec3(0.0F, step, 0.0F), {0.0F, -1.0F, 0.0F}}, 2.0F * step);
    if (under && under->normal.y < m_data.slopeCosine) {
        return WalkRefusal::Steep;
    }
    const glm::vec3 knee = point + glm::vec3(0.0F, kOpenGround, 0.0F);
    if (m_data.rays.hit({knee, {0.0F, 1.0F, 0.0F}}, m_data.height - kOpenGround)) {
        return WalkRefusal::Low;
    }
    const dtNavMeshQuery* query = m_data.query();
    const float metres = m_data.radius + kNearEdge;
    const float reach[3] = {metres, step, metres};
    NearestGround search(*query, m_data, point);
    const bool isBeside =
        query != nullptr &&
        dtStatusSucceed(query->queryPolygons(&point.x, reach, &m_data.everything, &search)) &&
        search.isFound() && search.flatSquared() <= metres * metres;
    return isBeside ? WalkRefusal::Narrow : WalkRefusal::Unlinked;
}

} // namespace crowd::behavior
