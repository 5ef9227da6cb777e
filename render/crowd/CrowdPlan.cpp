// SPDX-License-Identifier: MIT
#include "render/crowd/CrowdPlan.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "model/bake/KeyframeTime.h"
#include "model/base/Parallel.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr std::uint8_t kNoLevel = 0xFF;
constexpr std::size_t kChunk = 4096;
constexpr float kBoundsMargin = 1.1F; ///< a first keyframe stands in for a clip that moves more
constexpr float kNearest = 1.0F;      ///< metres, of the first distance step

/// What culling and sizing need of the view.
struct Eye
{
    std::array<glm::vec4, 6> planes; ///< inside is positive, unit normals
    glm::vec3 position;
    glm::vec3 forward;
    float pixelsPerMetre; ///< at one metre, or anywhere when orthographic
    bool isPerspective;
    float depthStep; ///< distance steps per doubling, or per metre when orthographic
};

Eye eyeOf(const View& view, float pixelRatio)
{
    Eye eye{};
    const glm::mat4 m = glm::transpose(view.viewProjection());
    eye.planes = {m[3] + m[0], m[3] - m[0], m[3] + m[1], m[3] - m[1], m[3] + m[2], m[3] - m[2]};
    for (glm::vec4& plane : eye.planes) {
        plane /= glm::length(glm::vec3(plane));
    }
    eye.position = view.camera().position;
    eye.forward = view.camera().forward();
    eye.isPerspective = view.camera().projection == Projection::Perspective;
    eye.pixelsPerMetre = view.pixelsPerMetre(1.0F) * pixelRatio;
    return eye;
}

bool isInside(const Eye& eye, const glm::vec3& center, float radius)
{
    return std::ranges::all_of(eye.planes, [&](const glm::vec4& plane) {
        return glm::dot(glm::vec3(plane), center) + plane.w > -radius;
    });
}

/// Four steps per doubling of the distance, without a logarithm: the exponent and the top two bits
/// of the mantissa.
std::uint32_t distanceStep(const Eye& eye, float depth)
{
    const float scaled = eye.isPerspective ? std::max(depth / kNearest, 1.0F)
                                           : std::max(depth * 0.1F + 300.0F, 1.0F);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &scaled, sizeof(bits));
    const std::uint32_t step = (bits >> 21U) - (127U << 2U);
    return std::min<std::uint32_t>(step, CrowdPlan::kDistanceSteps - 1);
}

struct Sphere
{
    glm::vec3 center;
    float radius;
};

/// Around everything the clip reaches, for any heading.
Sphere sphereAround(const Bounds& box, const glm::vec3& foot, float lift, float height, float girth)
{
    const float middle = (box.low.y + box.high.y) * 0.5F;
    const float halfHeight = (box.high.y - box.low.y) * 0.5F * height;
    const float side = std::max({-box.low.x, box.high.x, -box.low.z, box.high.z}) * girth;
    return {foot + glm::vec3(0.0F, lift + middle * height, 0.0F),
            std::sqrt(halfHeight * halfHeight + 2.0F * side * side) * kBoundsMargin};
}

Instance instanceOf(const PlanClip& clip, float phase, float speed, double seconds, bool& isMissing)
{
    Instance instance;
    instance.boxes = clip.box | static_cast<std::uint32_t>(clip.box) << 16U;
    instance.keyframeA = clip.firstKeyframe;
    instance.keyframeB = clip.firstKeyframe;
    if (!clip.isComplete) {
        isMissing = true;
        return instance;
    }
    const KeyframePlace place =
        keyframePlace(*clip.clip, shownPhase(*clip.clip, phase, speed, seconds));
    instance.keyframeA += static_cast<std::uint32_t>(place.first);
    instance.keyframeB += static_cast<std::uint32_t>(place.second);
    instance.blend = place.blend;
    return instance;
}

/// Columns of a frame, looked up once.
struct Rows
{
    explicit Rows(const CrowdFrame& frame)
        : templates(frame.population.column(columns::templateId)),
          positions(frame.population.column(columns::position)),
          heights(frame.population.column(columns::height)),
          girths(frame.population.column(columns::girth)),
          clips(frame.population.column(columns::clip)),
          phases(frame.population.column(columns::phase)),
          speeds(frame.population.column(columns::playbackSpeed)),
          entryOfId(std::size_t{1} << 16U, -1)
    {
        for (std::size_t i = 0; i < frame.templates->size(); ++i) {
            entryOfId[(*frame.templates)[i].id] = static_cast<std::int32_t>(i);
        }
    }

    std::span<const TemplateId> templates;
    std::span<const glm::vec3> positions;
    std::span<const float> heights;
    std::span<const float> girths;
    std::span<const std::uint16_t> clips;
    std::span<const float> phases;
    std::span<const float> speeds;
    std::vector<std::int32_t> entryOfId;
};

/// Stable counting sort of `from` by key(item) < keys into `to`.
template<class Key>
void countingSort(const std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& to,
                  std::vector<std::uint32_t>& counts, std::size_t keys, const Key& key)
{
    counts.assign(keys + 1, 0);
    for (const std::uint32_t item : from) {
        ++counts[key(item) + 1];
    }
    std::partial_sum(counts.begin(), counts.end(), counts.begin());
    to.resize(from.size());
    for (const std::uint32_t item : from) {
        to[counts[key(item)]++] = item;
    }
}

} // namespace

int levelFor(float pixels, int last, int levels, const LevelThresholds& thresholds)
{
    int level = 0;
    for (int i = 0; i + 1 < levels; ++i) {
        // Already coarser: it takes more to come back. Still finer: it takes less to stay.
        const float shift = last < 0   ? 1.0F
                            : last > i ? 1.0F + thresholds.hysteresis
                                       : 1.0F - thresholds.hysteresis;
        if (pixels < thresholds.pixels[static_cast<std::size_t>(i)] * shift) {
            level = i + 1;
        }
    }
    return level;
}

void CrowdPlan::reset()
{
    m_lastPopulation = {};
    m_levels.clear();
}

/// Carries the levels over to the rows that the same individuals have now.
void CrowdPlan::keepLevels(const Population& population)
{
    const bool areRowsTheSame = population.rowsVersion() == m_lastPopulation.rowsVersion() &&
                                m_levels.size() == population.size();
    if (!areRowsTheSame) {
        std::vector<std::uint8_t> levels(population.size(), kNoLevel);
        const std::span<const IndividualId> before = m_lastPopulation.ids();
        const std::span<const IndividualId> now = population.ids();
        std::size_t old = 0;
        for (std::size_t row = 0; row < now.size() && !m_levels.empty(); ++row) {
            while (old < before.size() && before[old] < now[row]) {
                ++old;
            }
            if (old < before.size() && before[old] == now[row]) {
                levels[row] = m_levels[old];
            }
        }
        m_levels = std::move(levels);
    }
    m_lastPopulation = population;
}

void CrowdPlan::mark(const Request& request)
{
    const std::span<const IndividualId> ids = request.frame.population.ids();
    m_flags.assign(ids.size(), 0);
    std::size_t row = 0;
    for (const IndividualId id : request.selected) {
        while (row < ids.size() && ids[row] < id) {
            ++row;
        }
        if (row < ids.size() && ids[row] == id) {
            m_flags[row] = Instance::kSelected >> 24U;
        }
    }
    const std::size_t hovered = request.frame.population.rowOf(request.hovered);
    if (hovered != Population::npos) {
        m_flags[hovered] |= static_cast<std::uint8_t>(Instance::kHovered >> 24U);
    }
}

void CrowdPlan::look(const Request& request)
{
    const Rows rows(request.frame);
    const Eye eye = eyeOf(request.view, request.pixelRatio);
    const std::size_t count = request.frame.population.size();
    const std::size_t entries = request.templates.size();
    m_seenByChunk.resize((count + kChunk - 1) / kChunk);
    std::vector<std::uint8_t> missing(m_seenByChunk.size(), 0);
    const auto lookAt = [&](std::size_t row, std::vector<Seen>& seen, bool& isMissing) {
        const std::int32_t entry = rows.entryOfId[rows.templates[row]];
        if (entry < 0 || !request.templates[static_cast<std::size_t>(entry)].isDrawable) {
            return;
        }
        const PlanTemplate& asset = request.templates[static_cast<std::size_t>(entry)];
        const std::size_t name =
            std::min<std::size_t>(rows.clips[row], asset.clipOfName.size() - 1);
        const PlanClip& clip = asset.clips[asset.clipOfName[name]];
        const Sphere sphere = sphereAround(clip.bounds, rows.positions[row], request.lifts[row],
                                           rows.heights[row], rows.girths[row]);
        if (!isInside(eye, sphere.center, sphere.radius)) {
            m_levels[row] = kNoLevel;
            return;
        }
        const float depth = glm::dot(sphere.center - eye.position, eye.forward);
        const float scale =
            eye.isPerspective ? eye.pixelsPerMetre / std::max(depth, 0.1F) : eye.pixelsPerMetre;
        const int last = m_levels[row] == kNoLevel ? -1 : m_levels[row];
        const int level = levelFor(asset.height * rows.heights[row] * scale, last, asset.levels,
                                   request.thresholds);
        m_levels[row] = static_cast<std::uint8_t>(level);
        Seen item;
        item.instance =
            instanceOf(clip, rows.phases[row], rows.speeds[row], request.frame.seconds, isMissing);
        item.instance.rowAndFlags =
            static_cast<std::uint32_t>(row) | static_cast<std::uint32_t>(m_flags[row]) << 24U;
        item.group = (static_cast<std::uint32_t>(level) * static_cast<std::uint32_t>(entries) +
                      static_cast<std::uint32_t>(entry)) *
                         kDistanceSteps +
                     distanceStep(eye, depth);
        seen.push_back(item);
    };
    parallelFor(count, kChunk, [&](std::size_t begin, std::size_t end) {
        std::vector<Seen>& seen = m_seenByChunk[begin / kChunk];
        seen.clear();
        bool isMissing = false;
        for (std::size_t row = begin; row < end; ++row) {
            lookAt(row, seen, isMissing);
        }
        missing[begin / kChunk] = isMissing ? 1 : 0;
    });
    m_areKeyframesMissing = std::ranges::find(missing, 1) != missing.end();
}

void CrowdPlan::sortSeen(std::size_t entries)
{
    m_seen.clear();
    std::uint32_t keyframes = 0;
    for (const std::vector<Seen>& chunk : m_seenByChunk) {
        m_seen.insert(m_seen.end(), chunk.begin(), chunk.end());
    }
    for (const Seen& seen : m_seen) {
        keyframes = std::max(keyframes, seen.instance.keyframeA + 1);
    }
    m_order.resize(m_seen.size());
    std::iota(m_order.begin(), m_order.end(), 0U);
    countingSort(m_order, m_orderByKeyframe, m_counts, keyframes,
                 [this](std::uint32_t i) { return m_seen[i].instance.keyframeA; });
    const std::size_t groups = entries * kMaxLevels * kDistanceSteps;
    countingSort(m_orderByKeyframe, m_order, m_counts, groups,
                 [this](std::uint32_t i) { return m_seen[i].group; });
    m_instances.resize(m_seen.size());
    m_runs.clear();
    m_byLevel = {};
    std::uint32_t lastRun = 0xFFFFFFFFU;
    for (std::size_t i = 0; i < m_order.size(); ++i) {
        const Seen& seen = m_seen[m_order[i]];
        m_instances[i] = seen.instance;
        const std::uint32_t run = seen.group / kDistanceSteps;
        if (run != lastRun) {
            m_runs.push_back(
                {static_cast<int>(run % entries), static_cast<int>(run / entries), i, 0});
            lastRun = run;
        }
        ++m_runs.back().count;
    }
    for (const InstanceRun& run : m_runs) {
        m_byLevel[static_cast<std::size_t>(run.level)] += static_cast<int>(run.count);
    }
}

void CrowdPlan::collectHighlighted()
{
    m_highlighted.clear();
    m_highlightedRuns.clear();
    for (const InstanceRun& run : m_runs) {
        InstanceRun marked{run.entry, run.level, m_highlighted.size(), 0};
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            if ((m_instances[i].rowAndFlags & (Instance::kSelected | Instance::kHovered)) != 0) {
                m_highlighted.push_back(m_instances[i]);
            }
        }
        marked.count = m_highlighted.size() - marked.first;
        if (marked.count > 0) {
            m_highlightedRuns.push_back(marked);
        }
    }
}

void CrowdPlan::make(const Request& request)
{
    keepLevels(request.frame.population);
    mark(request);
    look(request);
    sortSeen(request.templates.size());
    if (!request.selected.empty() || request.hovered != 0) {
        collectHighlighted();
    } else {
        m_highlighted.clear();
        m_highlightedRuns.clear();
    }
}

} // namespace crowd::render
