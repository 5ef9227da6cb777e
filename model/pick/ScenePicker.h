// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/bake/KeyframeStore.h"
#include "model/pick/ScreenArea.h"
#include "model/pick/StageRays.h"
#include "model/scene/CrowdFrame.h"
#include "model/view/View.h"

namespace crowd::model {

/// Somebody under a pixel.
struct IndividualHit
{
    IndividualId id = 0;
    float distance = 0.0F; ///< metres along the ray through the pixel
    glm::vec3 point{0.0F}; ///< world frame
    int slot = -1;         ///< of the triangle that is hit; -1 where only a box was looked at
};

enum class AreaMode : std::uint8_t {
    Visible, ///< with any pixel on screen inside, not hidden by others or by the stage
    Through  ///< with any pixel inside, hidden or not
};

/// Finds people and places on screen, on what is shown: each in the keyframe of frame->seconds,
/// seated people lifted as they are drawn. Positions in logical pixels of the view.
///
/// Visible is decided by a software id-buffer of the area at one sample a logical pixel (nearest
/// triangle wins, ties go to the smaller id), each individual's remaining pixels then tried
/// against the stage by rays. People under 8 pixels high count as their box.
/// Deterministic for the same frame, view and baked clips; queries are thread-safe among
/// themselves, update() is not.
class ScenePicker
{
public:
    /// Both must outlive the picker.
    ScenePicker(KeyframeStore& keyframes, const StageRays& stage);
    ~ScenePicker();
    ScenePicker(const ScenePicker&) = delete;
    ScenePicker& operator=(const ScenePicker&) = delete;

    /// Lets go of the frame and its templates, until the next update().
    void forget();
    /// What is shown. Cheap when only the time changed; rebuilds the index when people or the view
    /// changed (about 4 ms for 100 000). `seats` are Scene::worldSeats(), ascending by id.
    void update(CrowdFramePtr frame, std::span<const WorldSeat> seats, const View& view);
    /// Takes individuals out of all later answers until the next update() with changed people.
    void exclude(std::span<const IndividualId> ids);

    /// The frontmost individual at a pixel; nobody when the stage is nearer.
    [[nodiscard]] std::optional<IndividualHit> individualAt(glm::dvec2 pixel) const;
    /// All individuals at a pixel, nearest first, also behind others and the stage.
    [[nodiscard]] std::vector<IndividualHit> individualsThrough(glm::dvec2 pixel) const;
    /// Ascending ids.
    [[nodiscard]] std::vector<IndividualId> individualsInArea(const ScreenArea& area,
                                                              AreaMode mode) const;
    /// Stage or ground under a pixel; people are looked through.
    [[nodiscard]] std::optional<SurfaceHit> surfaceAt(glm::dvec2 pixel) const;

    [[nodiscard]] const View& view() const;

    /// How much work queries did so far: candidates taken from the index.
    [[nodiscard]] std::uint64_t candidateVisits() const;

private:
    struct Private;
    std::unique_ptr<Private> m_private;
};

} // namespace crowd::model
