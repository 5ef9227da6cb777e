// SPDX-License-Identifier: MIT
#include "render/crowd/CrowdPlan.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

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

/// A clip name of a template entry with all that does not differ between individuals computed.
struct ReadyClip
{
    explicit ReadyClip(const PlanClip& clip)
        : firstKeyframe(clip.firstKeyframe),
          boxes(clip.box | static_cast<std::uint32_t>(clip.box) << 16U),
          isComplete(clip.isComplete), loops(clip.clip->loop), seconds(clip.clip->seconds),
          last(clip.clip->keyframeCount() - 1)
    {
        const Bounds& box = clip.bounds;
        const glm::vec3 size = box.size() * kBoundsMargin;
        middle = (box.low.y + box.high.y) * 0.5F;
        halfHeight = size.y * 0.5F;
        shownHeight = box.size().y;
        const float reach = std::max({-box.low.x, box.high.x, -box.low.z, box.high.z});
        side = reach * kBoundsMargin * 1.4142136F;
        if (last > 0) {
            perSecond = 1.0 / static_cast<double>(seconds);
            lastBegin = static_cast<float>(last - 1) / static_cast<float>(kKeyframeRate);
            perLastWidth = 1.0F / (seconds - lastBegin);
        }
    }

    std::uint32_t firstKeyframe;
    std::uint32_t boxes;
    bool isComplete;
    bool loops;
    float seconds;
    int last;     ///< keyframe, 0 for a pose
    float middle; ///< metres, of the bounds' height
    float halfHeight;
    float shownHeight;      ///< metres; less than the template's where people sit
    float side;             ///< largest distance from the axis
    double perSecond = 0.0; ///< clips
    float lastBegin = 0.0F; ///< seconds, of the last interval
    float perLastWidth = 0.0F;
};

/// The same places as shownPhase and keyframePlace give, with the divisions done before.
void place(const ReadyClip& clip, float phase, float speed, double seconds, Instance& instance)
{
    instance.boxes = clip.boxes;
    instance.keyframeA = clip.firstKeyframe;
    instance.keyframeB = clip.firstKeyframe;
    instance.blend = 0.0F;
    if (!clip.isComplete || clip.last == 0) {
        return;
    }
    const double clips =
        static_cast<double>(phase) + seconds * static_cast<double>(speed) * clip.perSecond;
    double share = clips - static_cast<double>(static_cast<std::int64_t>(clips));
    share += share < 0.0 ? 1.0 : 0.0;
    if (!clip.loops) {
        share = std::clamp(clips, 0.0, 1.0);
    }
    const float at = static_cast<float>(share) * clip.seconds;
    const float keyframe = at * static_cast<float>(kKeyframeRate);
    const int first = std::min(static_cast<int>(keyframe), clip.last - 1);
    const float blend = first == clip.last - 1 ? (at - clip.lastBegin) * clip.perLastWidth
                                               : keyframe - static_cast<float>(first);
    instance.keyframeA += static_cast<std::uint32_t>(first);
    instance.keyframeB = instance.keyframeA + 1;
    instance.blend = std::clamp(blend, 0.0F, 1.0F);
}

/// Columns of a frame, looked up once.
struct Rows
{
    Rows(const CrowdFrame& frame, std::span<const PlanTemplate> assets)
        : templates(frame.population.column(columns::templateId)),
          positions(frame.population.column(columns::position)),
          heights(frame.population.column(columns::height)),
          girths(frame.population.column(columns::girth)),
          clips(frame.population.column(columns::clip)),
          phases(frame.population.column(columns::phase)),
          speeds(frame.population.column(columns::playbackSpeed)), entries(frame.templates->size())
    {
        TemplateId highest = 0;
        for (const TemplateEntry& entry : *frame.templates) {
            highest = std::max(highest, entry.id);
        }
        entryOfId.assign(std::size_t{highest} + 1, nullptr);
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (assets[i].isDrawable) {
                fill(entries[i], assets[i], static_cast<std::uint32_t>(i));
                entryOfId[(*frame.templates)[i].id] = &entries[i];
            }
        }
    }

    struct Entry
    {
        std::vector<ReadyClip> clips; ///< as TemplateEntry::clipNames
        float height = 0.0F;
        int levels = 1;
        std::uint32_t index = 0;
    };

    static void fill(Entry& entry, const PlanTemplate& asset, std::uint32_t index)
    {
        for (const std::uint16_t clip : asset.clipOfName) {
            entry.clips.emplace_back(asset.clips[clip]);
        }
        entry.height = asset.height;
        entry.levels = asset.levels;
        entry.index = index;
    }

    [[nodiscard]] const Entry* entryOf(TemplateId id) const
    {
        return id < entryOfId.size() ? entryOfId[id] : nullptr;
    }

    std::span<const TemplateId> templates;
    std::span<const glm::vec3> positions;
    std::span<const float> heights;
    std::span<const float> girths;
    std::span<const std::uint16_t> clips;
    std::span<const float> phases;
    std::span<const float> speeds;
    std::vector<Entry> entries;
    std::vector<const Entry*> entryOfId; ///< null: nothing to draw
};

/// Counts become the place of each key's first item.
void toStarts(std::vector<std::uint32_t>& counts)
{
    std::uint32_t sum = 0;
    for (std::uint32_t& count : counts) {
        sum += std::exchange(count, sum);
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
    const Rows rows(request.frame, request.templates);
    const Eye eye = eyeOf(request.view, request.pixelRatio);
    const std::size_t count = request.frame.population.size();
    const auto entries = static_cast<std::uint32_t>(request.templates.size());
    const double seconds = request.frame.seconds;
    const auto lookAt = [&](std::size_t row, Seen& seen) {
        const Rows::Entry* entry = rows.entryOf(rows.templates[row]);
        if (entry == nullptr) {
            return;
        }
        const ReadyClip& clip =
            entry->clips[std::min<std::size_t>(rows.clips[row], entry->clips.size() - 1)];
        const float height = rows.heights[row];
        glm::vec3 center = rows.positions[row];
        center.y += request.lifts[row] + clip.middle * height;
        if (!isInside(eye, center, clip.halfHeight * height + clip.side * rows.girths[row])) {
            m_levels[row] = kNoLevel;
            return;
        }
        const float depth = glm::dot(center - eye.position, eye.forward);
        const float scale =
            eye.isPerspective ? eye.pixelsPerMetre / std::max(depth, 0.1F) : eye.pixelsPerMetre;
        const int last = m_levels[row] == kNoLevel ? -1 : m_levels[row];
        const int level = levelFor(std::min(entry->height, clip.shownHeight) * height * scale, last,
                                   entry->levels, request.thresholds);
        m_levels[row] = static_cast<std::uint8_t>(level);
        Instance& instance = seen.instances[seen.count];
        instance.rowAndFlags =
            static_cast<std::uint32_t>(row) | static_cast<std::uint32_t>(m_flags[row]) << 24U;
        place(clip, rows.phases[row], rows.speeds[row], seconds, instance);
        seen.groups[seen.count] =
            (static_cast<std::uint32_t>(level) * entries + entry->index) * kDistanceSteps +
            distanceStep(eye, depth);
        seen.isMissing = seen.isMissing || !clip.isComplete;
        ++seen.count;
    };
    m_seen.resize((count + kChunk - 1) / kChunk);
    parallelFor(count, kChunk, [&](std::size_t begin, std::size_t end) {
        Seen& seen = m_seen[begin / kChunk];
        seen.instances.resize(kChunk);
        seen.groups.resize(kChunk);
        seen.count = 0;
        seen.isMissing = false;
        for (std::size_t row = begin; row < end; ++row) {
            lookAt(row, seen);
        }
    });
    m_areKeyframesMissing = std::ranges::any_of(m_seen, &Seen::isMissing);
}

/// Two stable counting sorts: by keyframe, then by what decides more.
void CrowdPlan::sortSeen(std::size_t entries)
{
    std::size_t count = 0;
    for (const Seen& seen : m_seen) {
        count += seen.count;
    }
    m_unsorted.resize(count);
    m_groups.resize(count);
    count = 0;
    for (const Seen& seen : m_seen) {
        std::copy_n(seen.instances.begin(), seen.count,
                    m_unsorted.begin() + static_cast<std::ptrdiff_t>(count));
        std::copy_n(seen.groups.begin(), seen.count,
                    m_groups.begin() + static_cast<std::ptrdiff_t>(count));
        count += seen.count;
    }
    m_counts.clear();
    for (const Instance& instance : m_unsorted) {
        if (instance.keyframeA >= m_counts.size()) {
            m_counts.resize(instance.keyframeA + 1, 0);
        }
        ++m_counts[instance.keyframeA];
    }
    toStarts(m_counts);
    m_byKeyframe.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        m_byKeyframe[m_counts[m_unsorted[i].keyframeA]++] = i;
    }
    m_counts.assign(entries * kMaxLevels * kDistanceSteps, 0);
    for (const std::uint32_t group : m_groups) {
        ++m_counts[group];
    }
    toStarts(m_counts);
    m_instances.resize(count);
    for (const std::uint32_t i : m_byKeyframe) {
        m_instances[m_counts[m_groups[i]]++] = m_unsorted[i];
    }
    makeRuns(entries);
}

/// After sorting, m_counts holds the end of each group.
void CrowdPlan::makeRuns(std::size_t entries)
{
    m_runs.clear();
    m_byLevel = {};
    std::size_t first = 0;
    for (std::size_t run = 0; run < entries * kMaxLevels; ++run) {
        const std::size_t end = m_counts[(run + 1) * kDistanceSteps - 1];
        if (end > first) {
            const std::size_t level = run / entries;
            m_runs.push_back(
                {static_cast<int>(run % entries), static_cast<int>(level), first, end - first});
            m_byLevel[level] += static_cast<int>(end - first);
        }
        first = end;
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
