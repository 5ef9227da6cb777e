// SPDX-License-Identifier: MIT
#include "behavior/surface/WalkSurface.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <recastnavigation/DetourNavMeshQuery.h>

#include "behavior/surface/NavMeshBuilder.h"
#include "behavior/surface/SurfaceAreas.h"
#include "behavior/surface/SurfaceData.h"
#include "behavior/surface/SurfaceFooting.h"
#include "behavior/surface/SurfaceGround.h"
#include "behavior/surface/SurfaceWalls.h"
#include "behavior/surface/SurfaceWays.h"

namespace crowd::behavior {

namespace {

constexpr float kReachedUp = 2.0F; ///< metres, or down
constexpr float kKneeUp = 0.5F;
constexpr float kPreference = 2.0F; ///< a metre elsewhere counts like so many on liked ground

void setCosts(const SurfacePlan& plan, dtQueryFilter& filter)
{
    // The search wants no metre to cost less than 1: liked ground does, the rest more.
    const bool hasLiked = std::ranges::any_of(plan.areas, [](const model::Place& place) {
        return place.role == model::PlaceRole::Preferred;
    });
    const float usual = hasLiked ? kPreference : 1.0F;
    filter.setAreaCost(RC_WALKABLE_AREA, usual);
    filter.setAreaCost(kPreferredArea, 1.0F);
    for (int step = 0; step < kSlowAreas; ++step) {
        filter.setAreaCost(kFirstSlowArea + step,
                           usual * static_cast<float>(kSlowAreas) / static_cast<float>(step + 1));
    }
}

/// Recast counts in small whole numbers, and ends the program where they run over.
SurfaceSettings tamed(const SurfaceSettings& settings)
{
    const SurfaceSettings usual;
    const auto within = [](float value, float low, float high, float otherwise) {
        return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
    };
    SurfaceSettings tame = settings;
    tame.radius = within(settings.radius, 0.05F, 5.0F, usual.radius);
    tame.height = within(settings.height, 0.2F, 20.0F, usual.height);
    tame.climb = within(settings.climb, 0.0F, 5.0F, usual.climb);
    tame.slopeDegrees = within(settings.slopeDegrees, 0.0F, 85.0F, usual.slopeDegrees);
    return tame;
}

} // namespace

WalkSurface::WalkSurface(std::unique_ptr<SurfaceData> data) : m_data(std::move(data)) {}
WalkSurface::~WalkSurface() = default;

model::Result<std::shared_ptr<const WalkSurface>> WalkSurface::build(const SurfacePlan& given,
                                                                     Progress& progress)
{
    SurfacePlan plan = given;
    plan.settings = tamed(plan.settings);
    const TriangleSoup soup = plan.isWorthwhile() ? soupOf(plan) : TriangleSoup();
    if (soup.triangles.empty()) {
        return model::Error{QT_TRANSLATE_NOOP(
            "Messages", "There is no stage to walk on; characters walk on open ground.")};
    }
    BuiltMesh built = buildNavMesh(soup, plan, progress);
    if (!built.mesh || progress.isOver()) {
        return model::Error{
            progress.isOver()
                ? QT_TRANSLATE_NOOP("Messages",
                                    "The walkable surface was not built: it was cancelled.")
                : QT_TRANSLATE_NOOP("Messages",
                                    "Nothing of the stage can be walked on; characters walk on "
                                    "open ground. Check its size, which way is up, and how wide, "
                                    "tall and steep characters can walk (Environment panel).")};
    }
    auto data = std::make_unique<SurfaceData>();
    data->mesh = std::move(built.mesh);
    data->cellHeight = built.cellHeight;
    data->walls = wallsOf(*data->mesh, soup.bounds, plan.settings);
    data->ground = SurfaceGround(*data->mesh, soup);
    data->polygons = data->ground.polygons();
    data->radius = plan.settings.radius;
    data->climb = plan.settings.climb;
    data->height = plan.settings.height;
    data->slopeCosine = std::cos(glm::radians(plan.settings.slopeDegrees));
    data->covered = soup.bounds;
    data->rays.setStages(plan.stages);
    data->filter.setIncludeFlags(kOpen);
    data->everything.setIncludeFlags(kOpen | kForbidden);
    setCosts(plan, data->filter);
    progress.done = 1.0F;
    return std::shared_ptr<const WalkSurface>(new WalkSurface(std::move(data)));
}

std::vector<glm::vec2> WalkSurface::way(const glm::vec3& from, const glm::vec3& to) const
{
    std::vector<glm::vec2> flat;
    for (const glm::vec3& corner : way(from, to, Lane())) {
        flat.emplace_back(corner.x, corner.z);
    }
    return flat;
}

std::vector<glm::vec3> WalkSurface::way(const glm::vec3& from, const glm::vec3& to,
                                        const Lane& lane) const
{
    return SurfaceWays(*m_data).way(from, to, lane);
}

std::optional<float> WalkSurface::wayMetres(const glm::vec3& from, const glm::vec3& to,
                                            float within) const
{
    return SurfaceWays(*m_data).wayMetres(from, to, within);
}

std::optional<bool> WalkSurface::isStraight(const glm::vec3& from, const glm::vec3& to) const
{
    return SurfaceWays(*m_data).isStraight(from, to);
}

std::optional<glm::vec3> WalkSurface::straight(const glm::vec3& from, const glm::vec3& to) const
{
    return SurfaceWays(*m_data).straight(from, to);
}

float WalkSurface::height(float x, float z, float near) const
{
    return SurfaceFooting(*m_data).height(x, z, near);
}

bool WalkSurface::follow(Footing& footing, const glm::vec3& feet) const
{
    return SurfaceFooting(*m_data).follow(footing, feet);
}

float WalkSurface::underfoot(float x, float z, float surfaceHeight) const
{
    return SurfaceFooting(*m_data).underfoot(x, z, surfaceHeight);
}

bool WalkSurface::isWalkable(const glm::vec3& point) const
{
    return SurfaceFooting(*m_data).isWalkable(point);
}

std::optional<glm::vec3> WalkSurface::nearest(const glm::vec3& point) const
{
    return SurfaceFooting(*m_data).nearest(point);
}

model::WalkRefusal WalkSurface::refusal(const glm::vec3& point) const
{
    return SurfaceFooting(*m_data).refusal(point);
}

std::vector<std::array<glm::vec3, 3>> WalkSurface::triangles() const
{
    return m_data->ground.triangles(m_data->cellHeight);
}

float WalkSurface::margin() const
{
    return m_data->radius;
}

bool WalkSurface::reaches(const glm::vec3& point, float metres) const
{
    const glm::vec3 within(metres, kReachedUp, metres);
    if (SurfaceFooting(*m_data).groundBeside(point, within)) {
        return true;
    }
    // A roof, for those who are on it; not the hollow in a wall.
    const dtNavMeshQuery* query = m_data->query();
    dtPolyRef polygon = 0;
    float nearest[3];
    return query != nullptr &&
           dtStatusSucceed(
               query->findNearestPoly(&point.x, &within.x, &m_data->filter, &polygon, nearest)) &&
           polygon != 0 && std::hypot(nearest[0] - point.x, nearest[2] - point.z) <= metres &&
           !m_data->rays.hit({{nearest[0], nearest[1] + kKneeUp, nearest[2]}, {0.0F, 1.0F, 0.0F}});
}

std::span<const Wall> WalkSurface::walls() const
{
    return m_data->walls;
}

std::size_t WalkSurface::polygons() const
{
    return m_data->polygons;
}

} // namespace crowd::behavior
