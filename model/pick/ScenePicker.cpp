// SPDX-License-Identifier: MIT
#include "model/pick/ScenePicker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/matrix.hpp>

#include "model/pick/ScreenIndex.h"
#include "model/pick/ShapeRaster.h"
#include "model/pick/ShownPeople.h"
#include "model/pick/VisibleShapes.h"

namespace crowd::model {

namespace {

bool meetsBox(const Ray& ray, const Bounds& box)
{
    float from = 0.0F;
    float to = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const float inverse = 1.0F / ray.direction[axis];
        const float a = (box.low[axis] - ray.origin[axis]) * inverse;
        const float b = (box.high[axis] - ray.origin[axis]) * inverse;
        // A ray within a flat side gives NaN, which leaves the range as it is.
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

/// Möller and Trumbore 1997, both sides. Infinity: no hit.
float hitTriangle(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    constexpr float kNone = std::numeric_limits<float>::infinity();
    const glm::vec3 ab = b - a;
    const glm::vec3 ac = c - a;
    const glm::vec3 p = glm::cross(ray.direction, ac);
    const float determinant = glm::dot(ab, p);
    if (determinant == 0.0F) {
        return kNone;
    }
    const float inverse = 1.0F / determinant;
    const glm::vec3 s = ray.origin - a;
    const float u = glm::dot(s, p) * inverse;
    const glm::vec3 q = glm::cross(s, ab);
    const float v = glm::dot(ray.direction, q) * inverse;
    const float t = glm::dot(ac, q) * inverse;
    return u >= 0.0F && v >= 0.0F && u + v <= 1.0F && t > 0.0F ? t : kNone;
}

struct ShapeHit
{
    float distance = std::numeric_limits<float>::infinity(); ///< along the ray
    int slot = -1;
};

/// The nearest triangle of the shown keyframe.
ShapeHit hitShape(const Ray& world, const ShownIndividual& shown, int level)
{
    const glm::mat4 toTemplate = glm::inverse(shown.worldFromTemplate());
    const Ray ray{glm::vec3(toTemplate * glm::vec4(world.origin, 1.0F)),
                  glm::vec3(toTemplate * glm::vec4(world.direction, 0.0F))};
    const BakedClip& baked = *shown.clip->baked;
    const auto keyframe = static_cast<std::size_t>(shown.keyframe);
    ShapeHit nearest;
    if (keyframe < baked.keyframeBounds.size() && !meetsBox(ray, baked.keyframeBounds[keyframe])) {
        return nearest;
    }
    const Mesh& mesh = shown.clip->asset->levels[static_cast<std::size_t>(level)];
    std::vector<glm::vec3> points(mesh.positions.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
        points[v] = baked.position(level, shown.keyframe, v);
    }
    for (const Submesh& submesh : mesh.submeshes) {
        if (submesh.part >= 0 && (shown.parts >> static_cast<unsigned>(submesh.part) & 1U) == 0) {
            continue;
        }
        for (std::uint32_t i = submesh.firstIndex; i + 2 < submesh.firstIndex + submesh.indexCount;
             i += 3) {
            const float distance =
                hitTriangle(ray, points[mesh.indices[i]], points[mesh.indices[i + 1]],
                            points[mesh.indices[i + 2]]);
            if (distance < nearest.distance) {
                nearest = {distance, submesh.slot};
            }
        }
    }
    return nearest;
}

} // namespace

struct ScenePicker::Private
{
    Private(KeyframeStore& store, const StageRays& rays) : keyframes(store), stage(rays) {}

    KeyframeStore& keyframes;
    const StageRays& stage;
    View view{Camera{}, glm::vec2(1.0F)};
    ShownPeople people;
    ScreenIndex index;
    std::vector<bool> isExcluded; ///< by row; empty: nobody
    std::uint64_t populationVersion = 0;
    std::uint64_t keyframesVersion = 0;
    const void* templates = nullptr;
    std::size_t seatCount = 0;
    std::uint64_t stageVersion = 0; ///< seats move with their stage

    [[nodiscard]] bool isUpToDate(const CrowdFrame& frame, std::size_t seats,
                                  const View& wanted) const;
    [[nodiscard]] std::vector<std::uint32_t> candidates(glm::dvec2 low, glm::dvec2 high) const;
    [[nodiscard]] std::optional<IndividualHit>
    hit(std::uint32_t row, const Ray& ray, glm::dvec2 pixel, const ShapeRaster& raster) const;
    [[nodiscard]] float axisDistance(const Ray& ray, float depth) const;
    [[nodiscard]] std::vector<IndividualId> idsOf(std::span<const std::uint32_t> rows) const;
};

bool ScenePicker::Private::isUpToDate(const CrowdFrame& frame, std::size_t seats,
                                      const View& wanted) const
{
    return people.frame() && populationVersion == frame.population.version() &&
           keyframesVersion == keyframes.version() && templates == frame.templates.get() &&
           people.frame()->hiddenGroups == frame.hiddenGroups && seatCount == seats &&
           stageVersion == stage.version() && wanted.camera() == view.camera() &&
           wanted.size() == view.size();
}

std::vector<std::uint32_t> ScenePicker::Private::candidates(glm::dvec2 low, glm::dvec2 high) const
{
    std::vector<std::uint32_t> rows = index.candidates(low, high);
    if (!isExcluded.empty()) {
        std::erase_if(rows, [&](std::uint32_t row) { return isExcluded[row]; });
    }
    return rows;
}

float ScenePicker::Private::axisDistance(const Ray& ray, float depth) const
{
    const glm::vec3 forward = view.camera().forward();
    const float start = glm::dot(ray.origin - view.camera().position, forward);
    return (depth - start) / glm::dot(ray.direction, forward);
}

std::optional<IndividualHit> ScenePicker::Private::hit(std::uint32_t row, const Ray& ray,
                                                       glm::dvec2 pixel,
                                                       const ShapeRaster& raster) const
{
    const ShownIndividual shown = people.at(row);
    if (shown.clip == nullptr) {
        return std::nullopt;
    }
    ShapeHit found;
    if (const int level = raster.level(shown); level >= 0) {
        found = hitShape(ray, shown, level);
    } else {
        const ShapeRaster::Extent box = raster.smallBox(shown);
        if (pixel.x >= box.rect.x0 && pixel.x < box.rect.x1 && pixel.y >= box.rect.y0 &&
            pixel.y < box.rect.y1) {
            found.distance = axisDistance(ray, raster.depthOf(box.nearness));
        }
    }
    if (!std::isfinite(found.distance)) {
        return std::nullopt;
    }
    return IndividualHit{people.frame()->population.ids()[row], found.distance,
                         ray.origin + ray.direction * found.distance, found.slot};
}

std::vector<IndividualId> ScenePicker::Private::idsOf(std::span<const std::uint32_t> rows) const
{
    std::vector<IndividualId> ids;
    ids.reserve(rows.size());
    for (const std::uint32_t row : rows) {
        ids.push_back(people.frame()->population.ids()[row]);
    }
    return ids;
}

ScenePicker::ScenePicker(KeyframeStore& keyframes, const StageRays& stage)
    : m_private(std::make_unique<Private>(keyframes, stage))
{
}

ScenePicker::~ScenePicker() = default;

void ScenePicker::forget()
{
    m_private->people = {};
    m_private->index.build(m_private->people, m_private->view); // of nobody
    m_private->templates = nullptr;
}

void ScenePicker::update(CrowdFramePtr frame, std::span<const WorldSeat> seats, const View& view)
{
    Private& d = *m_private;
    const bool isSame = d.isUpToDate(*frame, seats.size(), view);
    const bool hasSamePeople = d.populationVersion == frame->population.version();
    d.view = view;
    d.populationVersion = frame->population.version();
    d.templates = frame->templates.get();
    d.seatCount = seats.size();
    d.stageVersion = d.stage.version();
    if (isSame) {
        d.people.setTime(std::move(frame));
        return;
    }
    if (!hasSamePeople) {
        d.isExcluded.clear();
    }
    // Read before asking: a clip that is finished meanwhile is taken over next time.
    d.keyframesVersion = d.keyframes.version();
    d.people.update(std::move(frame), seats, d.keyframes);
    d.index.build(d.people, d.view);
}

void ScenePicker::exclude(std::span<const IndividualId> ids)
{
    Private& d = *m_private;
    d.isExcluded.resize(d.people.size(), false);
    for (const IndividualId id : ids) {
        const std::size_t row = d.people.frame()->population.rowOf(id);
        if (row != Population::npos) {
            d.isExcluded[row] = true;
        }
    }
}

std::optional<IndividualHit> ScenePicker::individualAt(glm::dvec2 pixel) const
{
    const Private& d = *m_private;
    if (!d.people.frame()) {
        return std::nullopt;
    }
    const Ray ray = d.view.rayThrough(glm::vec2(pixel));
    const ShapeRaster raster(d.view);
    std::vector<std::uint32_t> rows = d.candidates(pixel, pixel);
    std::ranges::stable_sort(rows, {},
                             [&](std::uint32_t row) { return d.index.box(row).nearDepth; });
    std::optional<IndividualHit> nearest;
    for (const std::uint32_t row : rows) {
        if (nearest && d.axisDistance(ray, d.index.box(row).nearDepth) > nearest->distance) {
            break;
        }
        const auto found = d.hit(row, ray, pixel, raster);
        const bool isNearer =
            found && (!nearest || found->distance < nearest->distance ||
                      (found->distance == nearest->distance && found->id < nearest->id));
        if (isNearer) {
            nearest = found;
        }
    }
    if (nearest && d.stage.isBlocked(ray.origin, nearest->point)) {
        return std::nullopt;
    }
    return nearest;
}

std::vector<IndividualHit> ScenePicker::individualsThrough(glm::dvec2 pixel) const
{
    const Private& d = *m_private;
    std::vector<IndividualHit> hits;
    if (!d.people.frame()) {
        return hits;
    }
    const Ray ray = d.view.rayThrough(glm::vec2(pixel));
    const ShapeRaster raster(d.view);
    for (const std::uint32_t row : d.candidates(pixel, pixel)) {
        if (const auto found = d.hit(row, ray, pixel, raster)) {
            hits.push_back(*found);
        }
    }
    std::ranges::stable_sort(hits, {}, &IndividualHit::distance);
    return hits;
}

std::vector<IndividualId> ScenePicker::individualsInArea(const ScreenArea& area,
                                                         AreaMode mode) const
{
    const Private& d = *m_private;
    if (!d.people.frame()) {
        return {};
    }
    const AreaPixels pixels(area, d.view);
    const PixelRect& rect = pixels.rect();
    if (rect.isEmpty()) {
        return {};
    }
    const std::vector<std::uint32_t> rows =
        d.candidates({static_cast<double>(rect.x0), static_cast<double>(rect.y0)},
                     {static_cast<double>(rect.x1), static_cast<double>(rect.y1)});
    return d.idsOf(mode == AreaMode::Visible
                       ? visibleShapes(d.people, d.index, rows, pixels, d.view, d.stage)
                       : touchingShapes(d.people, d.index, rows, area, d.view));
}

std::optional<SurfaceHit> ScenePicker::surfaceAt(glm::dvec2 pixel) const
{
    return m_private->stage.hit(m_private->view.rayThrough(glm::vec2(pixel)));
}

const View& ScenePicker::view() const
{
    return m_private->view;
}

std::uint64_t ScenePicker::candidateVisits() const
{
    return m_private->index.visits();
}

} // namespace crowd::model
