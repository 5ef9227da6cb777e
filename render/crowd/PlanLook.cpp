// SPDX-License-Identifier: MIT
#include "render/crowd/PlanLook.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

// The same source for wider vectors, chosen at start; without contraction it gives the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CROWD_WIDE_CLONES __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define CROWD_WIDE_CLONES
#endif

namespace crowd::render {

namespace {

using namespace model;

constexpr float kBoundsMargin = 1.1F; ///< a first keyframe stands in for a clip that moves more
constexpr float kDiagonal = 1.4142136F;
constexpr float kLeastSquare = 1e-12F;
constexpr float kNearest = 0.1F; ///< metres: nobody is drawn as if he were nearer
constexpr std::uint32_t kLastStep = CrowdPlan::kDistanceSteps - 1;
constexpr std::uint8_t kNoLevel = CrowdPlan::kNoLevel;

constexpr std::size_t kPiece = PlanLook::kPieceRows;
using Floats = std::array<float, kPiece>;

/// Columns and clip values of some rows, for culling.
struct CullIn
{
    const glm::vec3* positions;
    const float* lifts;
    const float* heights;
    const float* girths;
    const float* middles;
    const float* halfHeights;
    const float* sides;
    const float* shownHeights;
};

/// Distance steps: four per doubling, without a logarithm: the exponent and the top two bits of the
/// mantissa. What lies before a metre, or 300 m before an orthographic eye, is in the first.
CROWD_WIDE_CLONES void cullRows(const PlanLook::Eye& eye, const CullIn& in, std::size_t count,
                                std::int32_t* __restrict isSeen, float* __restrict pixels,
                                std::uint32_t* __restrict steps, float* __restrict sines)
{
    const glm::vec4 from = eye.from;
    const std::array<glm::vec4, 6> planes = eye.planes;
    const glm::vec4 axis = eye.depth;
    const float* position = &in.positions->x;
    for (std::size_t i = 0; i < count; ++i) {
        const float x = position[i * 3];
        const float y = position[i * 3 + 1] + (in.lifts[i] + in.middles[i] * in.heights[i]);
        const float z = position[i * 3 + 2];
        const float reach = in.halfHeights[i] * in.heights[i] + in.sides[i] * in.girths[i];
        std::int32_t seen = 1;
        for (const glm::vec4& plane : planes) {
            seen &= plane.x * x + plane.y * y + plane.z * z + plane.w > -reach ? 1 : 0;
        }
        isSeen[i] = seen;
        const float depth = axis.x * x + axis.y * y + axis.z * z + axis.w;
        const float divisor = depth * eye.perDepth + eye.besideDepth;
        const float safe = divisor > kNearest ? divisor : kNearest;
        pixels[i] = in.shownHeights[i] * in.heights[i] * (eye.pixelsPerMetre / safe);
        const float scaled = depth * eye.stepScale + eye.stepShift;
        const std::uint32_t step =
            (std::bit_cast<std::uint32_t>(scaled > 1.0F ? scaled : 1.0F) >> 21U) - (127U << 2U);
        steps[i] = step < kLastStep ? step : kLastStep;
        const float awayX = from.x - from.w * x;
        const float awayY = from.y - from.w * y;
        const float awayZ = from.z - from.w * z;
        const float square = awayX * awayX + awayY * awayY + awayZ * awayZ;
        sines[i] = awayY / std::sqrt(square > kLeastSquare ? square : kLeastSquare);
    }
}

/// Of impostors, for what is seen from above at an angle of that sine.
std::uint8_t bandOf(float sine)
{
    std::size_t band = 0;
    for (const ImpostorBand& each : kImpostorBands) {
        band += sine > each.endSine ? 1U : 0U;
    }
    return static_cast<std::uint8_t>(std::min(band, kImpostorBands.size() - 1));
}

/// How far the clips of some rows are; see PlanLook::Course.
struct TimeIn
{
    const double* clips;  ///< phase and all clips since
    const double* isLoop; ///< 1 or 0
    const float* seconds;
    const float* lastBegins;
    const float* perLastWidths;
    const std::int32_t* lastIntervals;
};

/// The same places as shownPhase and keyframePlace give, with the divisions done before.
CROWD_WIDE_CLONES void placeInTime(const TimeIn& in, std::size_t count,
                                   std::int32_t* __restrict intervals, float* __restrict blends)
{
    constexpr double kRounding = 6755399441055744.0; ///< adding it leaves no room for fractions
    for (std::size_t i = 0; i < count; ++i) {
        const double clips = in.clips[i];
        double wrapped = clips - ((clips + kRounding) - kRounding);
        wrapped += wrapped < 0.0 ? 1.0 : 0.0;
        const double begun = clips > 0.0 ? clips : 0.0;
        const double ended = begun < 1.0 ? begun : 1.0;
        const double share = in.isLoop[i] > 0.0 ? wrapped : ended;
        const float at = static_cast<float>(share) * in.seconds[i];
        const float keyframe = at * static_cast<float>(kKeyframeRate);
        const auto begin = static_cast<std::int32_t>(keyframe);
        const std::int32_t last = in.lastIntervals[i];
        const std::int32_t interval = begin < last ? begin : last;
        const float within = keyframe - static_cast<float>(interval);
        const float atEnd = (at - in.lastBegins[i]) * in.perLastWidths[i];
        const float blend = interval == last ? atEnd : within;
        const float least = blend > 0.0F ? blend : 0.0F;
        intervals[i] = interval > 0 ? interval : 0;
        blends[i] = least < 1.0F ? least : 1.0F;
    }
}

} // namespace

/// What the loops over a few rows hand to each other.
struct PlanLook::Piece
{
    std::array<std::uint16_t, kPiece> clips; ///< index into m_extents and m_courses
    Floats middles;
    Floats halfHeights;
    Floats sides;
    Floats shownHeights;
    Floats pixels;
    std::array<std::uint32_t, kPiece> steps;
    Floats sines; ///< of the angles that they are seen from above at
    std::array<std::int32_t, kPiece> isSeen;
    std::array<std::uint16_t, kPiece> seen;  ///< offsets of those in view
    std::array<std::uint8_t, kPiece> levels; ///< of seen
    std::array<std::uint8_t, kPiece> bands;  ///< of seen; where the level is kImpostorLevel
    std::size_t count = 0;                   ///< of seen
};

PlanLook::PlanLook(const CrowdPlan::Request& request)
    : m_seconds(request.frame.seconds),
      m_groupsPerLevel(static_cast<std::uint32_t>(request.templates.size()) *
                       CrowdPlan::kDistanceSteps),
      m_choice(request.thresholds),
      m_templates(request.frame.population.column(columns::templateId)),
      m_positions(request.frame.population.column(columns::position)), m_lifts(request.lifts),
      m_heights(request.frame.population.column(columns::height)),
      m_girths(request.frame.population.column(columns::girth)),
      m_clips(request.frame.population.column(columns::clip)),
      m_phases(request.frame.population.column(columns::phase)),
      m_speeds(request.frame.population.column(columns::playbackSpeed)),
      m_fades(request.frame.fades), m_hiddenGroups(request.frame.hiddenGroups),
      m_groups(request.frame.population.column(columns::group))
{
    const Camera& camera = request.view.camera();
    const glm::mat4 m = glm::transpose(request.view.viewProjection());
    m_eye.planes = {m[3] + m[0], m[3] - m[0], m[3] + m[1], m[3] - m[1], m[3] + m[2], m[3] - m[2]};
    for (glm::vec4& plane : m_eye.planes) {
        plane /= glm::length(glm::vec3(plane));
    }
    if (request.isOfAll) {
        m_eye.planes.fill(glm::vec4(0.0F, 0.0F, 0.0F, 1.0F));
    }
    const bool isPerspective = camera.projection == Projection::Perspective;
    m_eye.from =
        isPerspective ? glm::vec4(camera.position, 1.0F) : glm::vec4(-camera.forward(), 0.0F);
    m_eye.depth = glm::vec4(camera.forward(), -glm::dot(camera.forward(), camera.position));
    m_eye.perDepth = isPerspective ? 1.0F : 0.0F;
    m_eye.besideDepth = isPerspective ? 0.0F : 1.0F;
    m_eye.stepScale = isPerspective ? 1.0F : 0.1F;
    m_eye.stepShift = isPerspective ? 0.0F : 300.0F;
    m_eye.pixelsPerMetre = request.view.pixelsPerMetre(1.0F) * request.pixelRatio;

    m_clipsOfId.resize(std::size_t{1} << 16U);
    m_extents.push_back({0.0F, -std::numeric_limits<float>::infinity(), 0.0F, 0.0F});
    m_courses.emplace_back();
    const std::vector<TemplateEntry>& entries = *request.frame.templates;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (request.templates[i].isDrawable) {
            addEntry(request.templates[i], entries[i].id, i);
        }
    }
}

void PlanLook::addEntry(const PlanTemplate& asset, TemplateId id, std::size_t index)
{
    m_clipsOfId[id] = {static_cast<std::uint16_t>(m_extents.size()),
                       static_cast<std::uint16_t>(asset.clipOfName.size() - 1)};
    // By the asset's clips, not by where they lie on the card: that depends on who asked first.
    std::vector<std::uint32_t> orders(asset.clips.size());
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < asset.clips.size(); ++i) {
        orders[i] = next;
        const Clip* clip = asset.clips[i].clip;
        next += clip != nullptr ? static_cast<std::uint32_t>(clip->keyframeCount()) : 0U;
    }
    m_orderEnd = std::max(m_orderEnd, next);
    for (const std::uint16_t clip : asset.clipOfName) {
        addClip(clip, asset, index, orders[clip]);
    }
}

void PlanLook::addClip(std::uint16_t clipIndex, const PlanTemplate& asset, std::size_t index,
                       std::uint32_t order)
{
    const PlanClip& clip = asset.clips[clipIndex];
    const Bounds& box = clip.bounds;
    const glm::vec3 size = box.size();
    const float reach = std::max({-box.low.x, box.high.x, -box.low.z, box.high.z});
    m_extents.push_back({(box.low.y + box.high.y) * 0.5F, size.y * kBoundsMargin * 0.5F,
                         reach * kBoundsMargin * kDiagonal, std::min(asset.height, size.y)});
    Course& course = m_courses.emplace_back();
    course.firstKeyframe = clip.firstKeyframe;
    course.order = order;
    course.boxes = clip.box | static_cast<std::uint32_t>(clip.box) << 16U;
    course.group = static_cast<std::uint32_t>(index) * CrowdPlan::kDistanceSteps;
    course.coarsest = std::min(asset.levels, static_cast<int>(kMaxLevels)) - 1;
    course.isMissing = !clip.isComplete;
    course.impostors = asset.hasImpostors && clip.isComplete ? &clip.impostors : nullptr;
    course.entry = static_cast<std::uint16_t>(index);
    course.clip = clipIndex;
    const int last = clip.clip->keyframeCount() - 1;
    if (!clip.isComplete || last == 0) {
        return;
    }
    course.isLoop = clip.clip->loop ? 1.0 : 0.0;
    course.seconds = clip.clip->seconds;
    course.perSecond = 1.0 / static_cast<double>(course.seconds);
    course.lastInterval = last - 1;
    course.lastBegin = static_cast<float>(last - 1) / static_cast<float>(kKeyframeRate);
    course.perLastWidth = 1.0F / (course.seconds - course.lastBegin);
    course.step = 1;
}

void PlanLook::rows(std::size_t begin, std::size_t end, std::span<std::uint8_t> levels,
                    std::span<const std::uint8_t> flags, PlanSeen& seen) const
{
    Piece piece;
    for (std::size_t first = begin; first < end; first += kPiece) {
        const std::size_t count = std::min(kPiece, end - first);
        gather(first, count, piece);
        if (!m_hiddenGroups.empty()) {
            hide(first, count, piece);
        }
        cull(first, count, piece);
        chooseLevels(levels.subspan(first, count), piece, seen);
        emit(first, flags, piece, seen);
    }
}

void PlanLook::gather(std::size_t begin, std::size_t count, Piece& piece) const
{
    for (std::size_t i = 0; i < count; ++i) {
        const Clips clips = m_clipsOfId[m_templates[begin + i]];
        const auto clip =
            static_cast<std::uint16_t>(clips.first + std::min(m_clips[begin + i], clips.last));
        const Extent& extent = m_extents[clip];
        piece.clips[i] = clip;
        piece.middles[i] = extent.middle;
        piece.halfHeights[i] = extent.halfHeight;
        piece.sides[i] = extent.side;
        piece.shownHeights[i] = extent.shownHeight;
    }
}

/// Those of hidden groups are never in view.
void PlanLook::hide(std::size_t begin, std::size_t count, Piece& piece) const
{
    for (std::size_t i = 0; i < count; ++i) {
        if (model::isAmong(m_hiddenGroups, m_groups[begin + i])) {
            piece.halfHeights[i] = m_extents.front().halfHeight;
        }
    }
}

void PlanLook::cull(std::size_t begin, std::size_t count, Piece& piece) const
{
    const CullIn in{&m_positions[begin], &m_lifts[begin],          &m_heights[begin],
                    &m_girths[begin],    piece.middles.data(),     piece.halfHeights.data(),
                    piece.sides.data(),  piece.shownHeights.data()};
    cullRows(m_eye, in, count, piece.isSeen.data(), piece.pixels.data(), piece.steps.data(),
             piece.sines.data());
    piece.count = 0;
    for (std::size_t i = 0; i < count; ++i) {
        piece.seen[piece.count] = static_cast<std::uint16_t>(i);
        piece.count += static_cast<std::size_t>(piece.isSeen[i]);
    }
}

void PlanLook::chooseLevels(std::span<std::uint8_t> levels, Piece& piece, PlanSeen& seen) const
{
    for (std::size_t k = 0; k < piece.count; ++k) {
        const std::size_t i = piece.seen[k];
        const Course& course = m_courses[piece.clips[i]];
        piece.levels[k] =
            static_cast<std::uint8_t>(m_choice.level(piece.pixels[i], levels[i], course.coarsest));
        if (course.impostors == nullptr || !m_choice.isImpostorSmall(piece.pixels[i], levels[i])) {
            continue;
        }
        const std::uint8_t band = bandOf(piece.sines[i]);
        const PlanImpostors& impostors = (*course.impostors)[band];
        if (impostors.isThere) {
            piece.levels[k] = kImpostorLevel;
            piece.bands[k] = band;
        } else if (!impostors.isNone) {
            seen.wanted[piece.clips[i]] |= static_cast<std::uint8_t>(1U << band);
        }
    }
    std::ranges::fill(levels, kNoLevel);
    for (std::size_t k = 0; k < piece.count; ++k) {
        levels[piece.seen[k]] = piece.levels[k];
    }
}

void PlanLook::emit(std::size_t begin, std::span<const std::uint8_t> flags, const Piece& piece,
                    PlanSeen& seen) const
{
    std::array<double, kPiece> clips;
    std::array<double, kPiece> isLoop;
    Floats seconds;
    Floats lastBegins;
    Floats perLastWidths;
    std::array<std::int32_t, kPiece> lastIntervals;
    for (std::size_t k = 0; k < piece.count; ++k) {
        const std::size_t row = begin + piece.seen[k];
        const Course& course = m_courses[piece.clips[piece.seen[k]]];
        clips[k] = static_cast<double>(m_phases[row]) +
                   m_seconds * static_cast<double>(m_speeds[row]) * course.perSecond;
        isLoop[k] = course.isLoop;
        seconds[k] = course.seconds;
        lastBegins[k] = course.lastBegin;
        perLastWidths[k] = course.perLastWidth;
        lastIntervals[k] = course.lastInterval;
    }
    std::array<std::int32_t, kPiece> intervals;
    Floats blends;
    placeInTime({clips.data(), isLoop.data(), seconds.data(), lastBegins.data(),
                 perLastWidths.data(), lastIntervals.data()},
                piece.count, intervals.data(), blends.data());
    Instance* instance = seen.instances.data() + seen.count;
    PlanSeen::Key* key = seen.keys.data() + seen.count;
    bool isMissing = seen.isMissing;
    for (std::size_t k = 0; k < piece.count; ++k) {
        const std::size_t i = piece.seen[k];
        const std::size_t row = begin + i;
        const Course& course = m_courses[piece.clips[i]];
        const std::uint32_t keyframe =
            course.firstKeyframe + static_cast<std::uint32_t>(intervals[k]);
        instance[k] = {static_cast<std::uint32_t>(row) | static_cast<std::uint32_t>(flags[row])
                                                             << 24U,
                       keyframe, keyframe + course.step, course.boxes, blends[k]};
        showImpostor(course, piece, k, static_cast<float>(intervals[k]) + blends[k], instance[k]);
        key[k] = {course.order + static_cast<std::uint32_t>(intervals[k]),
                  piece.levels[k] * m_groupsPerLevel + course.group + piece.steps[i]};
        isMissing |= course.isMissing;
    }
    if (!m_fades.empty()) {
        isMissing |= fade(begin, piece, {instance, piece.count});
    }
    seen.count += piece.count;
    seen.isMissing = isMissing;
}

void PlanLook::showImpostor(const Course& course, const Piece& piece, std::size_t k, float keyframe,
                            Instance& instance) const
{
    if (piece.levels[k] != kImpostorLevel) {
        return;
    }
    const PlanImpostors& impostors = (*course.impostors)[piece.bands[k]];
    instance.keyframeA =
        static_cast<std::uint32_t>(impostors.layout.phaseOf(keyframe, course.isLoop > 0.0));
    instance.keyframeB = impostors.set;
}

void PlanLook::list(std::span<const std::uint8_t> wanted, std::vector<WantedImpostors>& out) const
{
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        for (int band = 0; band < static_cast<int>(kImpostorBands.size()); ++band) {
            if ((wanted[i] >> static_cast<unsigned>(band) & 1U) != 0) {
                out.push_back({m_courses[i].entry, m_courses[i].clip, band});
            }
        }
    }
}

/// Who changes clips is drawn between the nearest keyframes of both. Their place in the order
/// stays: it is only there for the sake of speed.
bool PlanLook::fade(std::size_t begin, const Piece& piece, std::span<Instance> instances) const
{
    bool isMissing = false;
    auto next = std::ranges::lower_bound(m_fades, begin, {}, &ClipFade::row);
    for (std::size_t k = 0; k < piece.count && next != m_fades.end(); ++k) {
        const std::size_t row = begin + piece.seen[k];
        while (next != m_fades.end() && next->row < row) {
            ++next;
        }
        if (next == m_fades.end() || next->row != row) {
            continue;
        }
        const Clips clips = m_clipsOfId[m_templates[row]];
        if (piece.levels[k] == kImpostorLevel) {
            continue; // a card shows one clip alone: the new one
        }
        const Course& from = m_courses[clips.first + std::min(next->clip, clips.last)];
        if (from.isMissing || m_courses[piece.clips[piece.seen[k]]].isMissing) {
            isMissing = true;
            continue;
        }
        const float at = next->place * from.seconds * static_cast<float>(kKeyframeRate);
        const auto nearest = static_cast<std::int32_t>(std::lround(std::max(at, 0.0F)));
        Instance& shown = instances[k];
        const std::uint32_t to = shown.blend < 0.5F ? shown.keyframeA : shown.keyframeB;
        shown.keyframeA =
            from.firstKeyframe +
            from.step * static_cast<std::uint32_t>(std::min(nearest, from.lastInterval + 1));
        shown.keyframeB = to;
        shown.boxes = (from.boxes & 0xFFFFU) | (shown.boxes & 0xFFFF0000U);
        shown.blend = std::clamp(next->share, 0.0F, 1.0F);
    }
    return isMissing;
}

} // namespace crowd::render
