// SPDX-License-Identifier: MIT
#include "model/pick/StageRays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>

namespace crowd::model {

namespace {

/// Room left at the end of a blocking query, so that what stands on a surface is not hidden by it.
constexpr float kGrazingMetres = 0.03F;
constexpr float kStepPastSurface = 1.0e-3F;
constexpr int kMaxSurfacesBelow = 8;
/// By how much two ways of computing a distance may differ.
constexpr double kSlackMetres = 1.0e-3;
constexpr double kSlack = 1.0e-3;

/// Hits differ between instruction sets in their last bits: one is pinned. A single thread builds
/// the tree, so that it is the same each time.
const char* deviceConfig()
{
    return __builtin_cpu_supports("avx2") != 0 ? "threads=1,isa=avx2,hugepages=0"
                                               : "threads=1,isa=sse2,hugepages=0";
}

/// What of a stage entry decides its geometry.
struct Placed
{
    StagePtr asset;
    glm::vec3 position{0.0F};
    float headingRadians = 0.0F;
    float scale = 1.0F;
    friend bool operator==(const Placed&, const Placed&) = default;
};

RTCRay rtcRay(const Ray& ray, float from, float to)
{
    RTCRay out{};
    out.org_x = ray.origin.x;
    out.org_y = ray.origin.y;
    out.org_z = ray.origin.z;
    out.dir_x = ray.direction.x;
    out.dir_y = ray.direction.y;
    out.dir_z = ray.direction.z;
    out.tnear = from;
    out.tfar = to;
    out.mask = 0xFFFFFFFFU;
    return out;
}

bool isFinite(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// What is drawn from one side alone is not there from the other: whoever looks from behind a wall
/// sees through it. For single rays.
void passBackFaces(const RTCFilterFunctionNArguments* arguments)
{
    const auto* ray = reinterpret_cast<const RTCRay*>(arguments->ray);
    const auto* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
    const float along = hit->Ng_x * ray->dir_x + hit->Ng_y * ray->dir_y + hit->Ng_z * ray->dir_z;
    const bool isOneSided = arguments->geometryUserPtr == nullptr;
    if (isOneSided && along > 0.0F) {
        arguments->valid[0] = 0;
    }
}

/// Which triangle is met is Embree's to say, where from its plane: the library takes the
/// processor's approximation of 1/x, whose last bits differ between makes. `about`: the library's
/// distance, for triangles that are seen from their edge.
SurfaceHit met(const Ray& ray, const std::array<glm::dvec3, 3>& corners, float about)
{
    const glm::dvec3 origin(ray.origin);
    const glm::dvec3 direction(ray.direction);
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(across);
    const double along = glm::dot(across, direction);
    const double distance = glm::dot(across, corners[0] - origin) / along;
    const bool isSharp = std::abs(distance - about) <= kSlackMetres + kSlack * about;
    const double way = isSharp ? distance : about;
    const glm::dvec3 normal = length > 0.0 ? across / length : glm::dvec3(0.0, 1.0, 0.0);
    return {glm::vec3(origin + direction * way), glm::vec3(along > 0.0 ? -normal : normal),
            static_cast<float>(way), false};
}

std::optional<SurfaceHit> groundHit(const Ray& ray, float maxDistance)
{
    if (ray.origin.y <= 0.0F || ray.direction.y >= 0.0F) {
        return std::nullopt;
    }
    const float distance = -ray.origin.y / ray.direction.y;
    if (!(distance <= maxDistance) || !std::isfinite(distance)) {
        return std::nullopt;
    }
    glm::vec3 point = ray.origin + ray.direction * distance;
    point.y = 0.0F;
    return SurfaceHit{point, glm::vec3(0.0F, 1.0F, 0.0F), distance, true};
}

} // namespace

struct StageRays::Private
{
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<Placed> placed;
    Bounds bounds;
    std::uint64_t version = 0;

    void rebuild();
    void addMesh(const StageMesh& mesh, bool isTwoSided, const glm::mat4& worldFromStage);
    [[nodiscard]] std::optional<SurfaceHit> stageHit(const Ray& ray, float from, float to) const;
    [[nodiscard]] std::array<glm::dvec3, 3> corners(const RTCHit& hit) const;
};

void StageRays::Private::addMesh(const StageMesh& mesh, bool isTwoSided,
                                 const glm::mat4& worldFromStage)
{
    const std::size_t triangles = mesh.indices.size() / 3;
    if (triangles == 0 || mesh.positions.empty()) {
        return;
    }
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<glm::vec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(glm::vec3), mesh.positions.size()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), triangles));
    if (vertices != nullptr && indices != nullptr) {
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 world(worldFromStage * glm::vec4(mesh.positions[i], 1.0F));
            vertices[i] = isFinite(world) ? world : glm::vec3(0.0F);
            bounds.add(vertices[i]);
        }
        std::copy_n(mesh.indices.begin(), triangles * 3, indices);
        rtcSetGeometryUserData(geometry, isTwoSided ? this : nullptr);
        rtcCommitGeometry(geometry);
        (void)rtcAttachGeometry(scene, geometry);
    }
    rtcReleaseGeometry(geometry);
}

void StageRays::Private::rebuild()
{
    if (scene != nullptr) {
        rtcReleaseScene(scene);
    }
    bounds = {};
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                       RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    for (const Placed& stage : placed) {
        StageEntry entry;
        entry.position = stage.position;
        entry.headingRadians = stage.headingRadians;
        entry.scale = stage.scale;
        for (const StageMesh& mesh : stage.asset->meshes) {
            const auto material = static_cast<std::size_t>(mesh.material);
            const bool isTwoSided = material >= stage.asset->materials.size() ||
                                    stage.asset->materials[material].doubleSided;
            addMesh(mesh, isTwoSided, entry.worldFromStage());
        }
    }
    rtcCommitScene(scene);
    ++version;
}

std::array<glm::dvec3, 3> StageRays::Private::corners(const RTCHit& hit) const
{
    RTCGeometry geometry = rtcGetGeometry(scene, hit.geomID);
    const auto* vertices = static_cast<const glm::vec3*>(
        rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_VERTEX, 0));
    const auto* indices = static_cast<const std::uint32_t*>(
        rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_INDEX, 0));
    std::array<glm::dvec3, 3> corners{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = vertices[indices[std::size_t{3} * hit.primID + i]];
    }
    return corners;
}

std::optional<SurfaceHit> StageRays::Private::stageHit(const Ray& ray, float from, float to) const
{
    RTCRayHit query{};
    query.ray = rtcRay(ray, from, to);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return std::nullopt;
    }
    return met(ray, corners(query.hit), query.ray.tfar);
}

StageRays::StageRays() : m_private(std::make_unique<Private>())
{
    m_private->device = rtcNewDevice(deviceConfig());
    m_private->rebuild();
}

StageRays::~StageRays()
{
    rtcReleaseScene(m_private->scene);
    rtcReleaseDevice(m_private->device);
}

void StageRays::setStages(std::span<const StageEntry> stages)
{
    std::vector<Placed> placed;
    for (const StageEntry& entry : stages) {
        if (entry.asset) {
            placed.push_back({entry.asset, entry.position, entry.headingRadians, entry.scale});
        }
    }
    if (placed != m_private->placed) {
        m_private->placed = std::move(placed);
        m_private->rebuild();
    }
}

std::uint64_t StageRays::version() const
{
    return m_private->version;
}

const Bounds& StageRays::bounds() const
{
    return m_private->bounds;
}

std::optional<SurfaceHit> StageRays::hit(const Ray& ray, float maxDistance) const
{
    const auto stage = m_private->stageHit(ray, 0.0F, maxDistance);
    return stage ? stage : groundHit(ray, maxDistance);
}

bool StageRays::isBlocked(const glm::vec3& from, const glm::vec3& to) const
{
    const glm::vec3 way = to - from;
    const float length = glm::length(way);
    if (length <= kGrazingMetres || m_private->bounds.isEmpty()) {
        return false;
    }
    RTCRay ray = rtcRay({from, way / length}, 0.0F, length - kGrazingMetres);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.filter = &passBackFaces;
    rtcOccluded1(m_private->scene, &context, &ray);
    return ray.tfar < 0.0F;
}

std::vector<SurfaceHit> StageRays::below(const glm::vec3& from) const
{
    std::vector<SurfaceHit> surfaces;
    const Ray down{from, glm::vec3(0.0F, -1.0F, 0.0F)};
    float start = 0.0F;
    while (static_cast<int>(surfaces.size()) < kMaxSurfacesBelow) {
        const auto next = m_private->stageHit(down, start, std::numeric_limits<float>::infinity());
        if (!next) {
            break;
        }
        surfaces.push_back(*next);
        start = next->distance + kStepPastSurface;
    }
    if (const auto ground = groundHit(down, std::numeric_limits<float>::infinity())) {
        surfaces.push_back(*ground);
    }
    std::ranges::stable_sort(surfaces, {}, &SurfaceHit::distance);
    return surfaces;
}

float StageRays::heightNear(const glm::vec3& at) const
{
    const float top = (bounds().isEmpty() ? at.y : std::max(bounds().high.y, at.y)) + 1.0F;
    std::optional<float> nearest;
    for (const SurfaceHit& surface : below({at.x, top, at.z})) {
        if (!nearest || std::abs(surface.point.y - at.y) < std::abs(*nearest - at.y)) {
            nearest = surface.point.y;
        }
    }
    return nearest.value_or(at.y);
}

} // namespace crowd::model
