// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/bake/Impostor.h"
#include "model/base/Bounds.h"
#include "model/scene/CrowdFrame.h"
#include "model/view/View.h"
#include "render/RenderInput.h"

/// Who is drawn how: phase, cull, projected size, level, sort. No GL. The result is the same for
/// any number of threads.
namespace crowd::render {

/// Cards of a clip in a band (model::ImpostorSet) as the plan needs them.
struct PlanImpostors
{
    std::uint32_t set = 0; ///< row of the template's table of sets
    bool isThere = false;
    bool isNone = false; ///< and never will be
    model::ImpostorLayout layout;
};

/// A clip as the plan needs it.
struct PlanClip
{
    const model::Clip* clip = nullptr;
    std::uint32_t firstKeyframe = 0; ///< in the template's keyframe buffer
    bool isComplete = false;         ///< else only its first keyframe is there
    std::uint16_t box = 0;           ///< row of the template's clip boxes
    model::Bounds bounds;            ///< of what is there, template frame
    std::array<PlanImpostors, model::kImpostorBands.size()> impostors{};
};

/// A template entry as the plan needs it.
struct PlanTemplate
{
    bool isDrawable = false;
    bool hasImpostors = false;
    float height = 0.0F; ///< metres at scale 1, for the projected size
    int levels = 1;
    std::vector<PlanClip> clips;           ///< as in the asset; those nobody uses have no bounds
    std::vector<std::uint16_t> clipOfName; ///< TemplateEntry::clipNames → asset clip
};

/// What the vertex shader gets of an individual each frame.
struct Instance
{
    std::uint32_t rowAndFlags = 0;
    std::uint32_t keyframeA = 0; ///< of an impostor: its phase
    std::uint32_t keyframeB = 0; ///< its set
    std::uint32_t boxes = 0;     ///< A's in the low half, B's in the high one
    float blend = 0.0F;

    static constexpr std::uint32_t kSelected = 0x80000000U;
    static constexpr std::uint32_t kHovered = 0x40000000U;
    static constexpr std::uint32_t kRowMask = 0x00FFFFFFU;
};
static_assert(sizeof(Instance) == 20);

/// A run of instances of one template entry and level.
struct InstanceRun
{
    int entry = 0; ///< index into CrowdFrame::templates
    int level = 0; ///< or kImpostorLevel
    std::size_t first = 0;
    std::size_t count = 0;
};

/// The visible rows of a chunk, before sorting. Filled from the front; kept between frames.
struct PlanSeen
{
    std::vector<Instance> instances;
    struct Key
    {
        std::uint32_t keyframe = 0; ///< among those of all clips of the template, in their order
        std::uint32_t group = 0;    ///< (level × entries + entry) × kDistanceSteps + step
    };
    std::vector<Key> keys; ///< of instances
    std::size_t count = 0;
    bool isMissing = false; ///< somebody's clip, or the one he comes from, is not complete
    /// By PlanLook's courses, a bit for each band of impostors that are not there yet.
    std::vector<std::uint8_t> wanted;
};
static_assert(model::kImpostorBands.size() <= 8);

/// Impostors that would have been drawn.
struct WantedImpostors
{
    int entry = 0; ///< index into CrowdFrame::templates
    int clip = 0;  ///< as in the asset
    int band = 0;
};

/// Keeps each individual's level from frame to frame, for the hysteresis.
class CrowdPlan
{
public:
    struct Request
    {
        const model::CrowdFrame& frame;
        std::span<const PlanTemplate> templates; ///< one per frame template entry
        std::span<const float> lifts;            ///< per row: metres above the foot point
        const model::View& view;
        float pixelRatio = 1.0F; ///< physical per logical pixel
        LevelThresholds thresholds;
        std::span<const model::IndividualId> selected; ///< ascending
        model::IndividualId hovered = 0;
        bool isOfAll = false; ///< also of those out of view
    };
    /// Fills instances() and runs(): ordered by level (finest first), template, distance in coarse
    /// steps (nearest first), keyframe, row.
    void make(const Request& request);

    [[nodiscard]] std::span<const Instance> instances() const { return m_instances; }
    [[nodiscard]] std::span<const InstanceRun> runs() const { return m_runs; }
    /// The highlighted ones of instances(), as runs of highlighted().
    [[nodiscard]] std::span<const Instance> highlighted() const { return m_highlighted; }
    [[nodiscard]] std::span<const InstanceRun> highlightedRuns() const { return m_highlightedRuns; }
    [[nodiscard]] std::array<int, kDrawnLevels> byLevel() const { return m_byLevel; }
    /// Those that are not there yet.
    [[nodiscard]] std::span<const WantedImpostors> wantedImpostors() const { return m_wanted; }
    [[nodiscard]] bool areKeyframesMissing() const { return m_areKeyframesMissing; }

    static constexpr int kDistanceSteps = 32;
    static constexpr std::uint8_t kNoLevel = 0xFF; ///< not seen last time

private:
    void keepLevels(const model::Population& population);
    void look(const Request& request);
    void mark(const Request& request);
    void sortByKeyframe();
    void sortByGroup(std::size_t entries);
    void placeSorted();
    void makeRuns(std::size_t entries);
    void collectHighlighted();

    model::Population m_lastPopulation; ///< shares columns: says which row was whose
    std::vector<std::uint8_t> m_levels; ///< per row; or kNoLevel
    std::vector<std::uint8_t> m_flags;  ///< per row, highest byte of Instance::rowAndFlags
    /// Who is to be sorted: where in m_seen (chunk × kChunk + offset), and the group.
    struct Key
    {
        std::uint32_t place;
        std::uint32_t group;
    };
    std::vector<PlanSeen> m_seen; ///< per chunk
    std::uint32_t m_orderEnd = 0;
    std::vector<Key> m_byKeyframe;
    std::vector<std::uint32_t> m_places; ///< sorted
    std::vector<std::uint32_t> m_counts;
    std::vector<Instance> m_instances;
    std::vector<InstanceRun> m_runs;
    std::vector<Instance> m_highlighted;
    std::vector<InstanceRun> m_highlightedRuns;
    std::array<int, kDrawnLevels> m_byLevel{};
    std::vector<WantedImpostors> m_wanted;
    bool m_areKeyframesMissing = false;
};

} // namespace crowd::render
