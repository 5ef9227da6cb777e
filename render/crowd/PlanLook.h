// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/crowd/CrowdPlan.h"
#include "render/crowd/LevelChoice.h"

namespace crowd::render {

/// Looks at the rows of a frame: who is in view, how large, at which level and keyframe. Built once
/// a frame; then rows() may run on any thread. In four loops over a few hundred rows each, so that
/// the arithmetic of culling is done on vectors and the rest without branches. No GL.
class PlanLook
{
public:
    /// The request's spans must outlive this.
    explicit PlanLook(const CrowdPlan::Request& request);

    /// Appends the visible rows of [begin, end) to `seen`, which has room for them. `levels` and
    /// `flags` are per row of the frame; the former are brought up to date.
    void rows(std::size_t begin, std::size_t end, std::span<std::uint8_t> levels,
              std::span<const std::uint8_t> flags, PlanSeen& seen) const;
    /// Above every key of PlanSeen.
    [[nodiscard]] std::uint32_t orderEnd() const { return m_orderEnd; }
    /// Of PlanSeen::wanted.
    [[nodiscard]] std::size_t courses() const { return m_courses.size(); }
    void list(std::span<const std::uint8_t> wanted, std::vector<WantedImpostors>& out) const;

    static constexpr std::size_t kPieceRows = 512;

    /// What culling and sizing need of the view.
    struct Eye
    {
        std::array<glm::vec4, 6> planes; ///< inside is positive, unit normals
        glm::vec4 depth;                 ///< times a point: metres before the eye
        float pixelsPerMetre;            ///< at one metre, or anywhere when orthographic
        float perDepth;                  ///< pixels shrink with depth × perDepth + besideDepth
        float besideDepth;
        glm::vec4 from;  ///< where it is; 0 in w: the direction towards it
        float stepScale; ///< of the depth, for its distance step
        float stepShift;
    };

private:
    /// Size of a clip, for culling; metres at scale 1.
    struct Extent
    {
        float middle = 0.0F;      ///< of the bounds' height
        float halfHeight = 0.0F;  ///< minus infinity: never in view
        float side = 0.0F;        ///< largest distance from the axis
        float shownHeight = 0.0F; ///< less than the template's where people sit
    };
    /// How a clip runs. One that stands still has zeros all over.
    struct Course
    {
        double perSecond = 0.0; ///< clips
        float seconds = 0.0F;   ///< long
        float lastBegin = 0.0F; ///< seconds, of the last interval
        float perLastWidth = 0.0F;
        std::int32_t lastInterval = 0;
        std::uint32_t firstKeyframe = 0;
        std::uint32_t order = 0; ///< of its first keyframe among those of all the template's clips
        std::uint32_t step = 0;  ///< to the second keyframe: 0 or 1
        std::uint32_t boxes = 0;
        std::uint32_t group = 0;   ///< entry × kDistanceSteps
        std::int32_t coarsest = 0; ///< level
        double isLoop = 1.0;       ///< or 0
        bool isMissing = false;
        /// By band; null: there are none.
        const std::array<PlanImpostors, model::kImpostorBands.size()>* impostors = nullptr;
        std::uint16_t entry = 0;
        std::uint16_t clip = 0; ///< as in the asset
    };
    /// Where a template id's clips lie.
    struct Clips
    {
        std::uint16_t first = 0; ///< 0: the one that is never in view
        std::uint16_t last = 0;  ///< offset
    };
    struct Piece;

    void addEntry(const PlanTemplate& asset, model::TemplateId id, std::size_t index);
    void addClip(std::uint16_t clip, const PlanTemplate& asset, std::size_t index,
                 std::uint32_t order);
    void gather(std::size_t begin, std::size_t count, Piece& piece) const;
    void hide(std::size_t begin, std::size_t count, Piece& piece) const;
    void cull(std::size_t begin, std::size_t count, Piece& piece) const;
    void chooseLevels(std::span<std::uint8_t> levels, Piece& piece, PlanSeen& seen) const;
    /// Where that is his level.
    void showImpostor(const Course& course, const Piece& piece, std::size_t k, float keyframe,
                      Instance& instance) const;
    void emit(std::size_t begin, std::span<const std::uint8_t> flags, const Piece& piece,
              PlanSeen& seen) const;
    /// Whether a clip that somebody comes from is not there yet.
    [[nodiscard]] bool fade(std::size_t begin, const Piece& piece,
                            std::span<Instance> instances) const;

    Eye m_eye;
    double m_seconds;
    std::uint32_t m_groupsPerLevel; ///< entries × kDistanceSteps
    std::uint32_t m_orderEnd = 1;
    std::vector<Clips> m_clipsOfId; ///< by template id
    std::vector<Extent> m_extents;  ///< the first is never in view
    std::vector<Course> m_courses;
    LevelChoice m_choice;

    std::span<const model::TemplateId> m_templates;
    std::span<const glm::vec3> m_positions;
    std::span<const float> m_lifts;
    std::span<const float> m_heights;
    std::span<const float> m_girths;
    std::span<const std::uint16_t> m_clips;
    std::span<const float> m_phases;
    std::span<const float> m_speeds;
    std::span<const model::ClipFade> m_fades;
    std::span<const model::GroupId> m_hiddenGroups;
    std::span<const model::GroupId> m_groups;
};

} // namespace crowd::render
