// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/scene/Scene.h"

namespace crowd::behavior {

/// Which clips of a template to stand, walk and run with: those that are gaits by their role.
/// Others that move over the ground are there for who asks for them. Immutable once made.
class GaitTable
{
public:
    struct Gait
    {
        std::uint16_t clip = 0;       ///< as the clip column counts
        float metresPerSecond = 0.0F; ///< at playback speed 1 and height 1; 0: standing
        float seconds = 1.0F;         ///< of the clip; 0 a pose
        bool isFree = false;          ///< plays at its own pace: no foot touches the ground
        bool isFrozen = false;        ///< a walk to stand with: it stays where it is
        /// Places in the clip, ascending, where the feet pass each other.
        std::vector<float> feetTogether{};
    };

    /// Empty where the template is not loaded or has nothing to move with: its people glide with
    /// the clip they have.
    explicit GaitTable(const model::TemplateEntry& entry);

    [[nodiscard]] bool isEmpty() const { return m_gaits.size() < 2; }
    /// Whether a clip (as the clip column counts) is a gait, which nobody plays who stands.
    [[nodiscard]] bool isMover(std::size_t clip) const;
    /// The last one beyond the end: the table may be another than when the index was chosen.
    [[nodiscard]] const Gait& gait(std::size_t index) const
    {
        return m_gaits[std::min(index, m_gaits.size() - 1)];
    }
    /// The gait for a ground speed, given the present one: a border must be crossed by some way
    /// before the gait changes, so that nobody flickers between two.
    /// `style`: the only one to move with, 0 for any.
    [[nodiscard]] std::size_t choose(std::size_t present, float metresPerSecond,
                                     std::size_t style = 0) const;
    /// Speeds between which choose() keeps to the present gait, m/s.
    struct Limits
    {
        float slowest = 0.0F;
        float fastest = 0.0F;
    };
    [[nodiscard]] Limits limits(std::size_t present, std::size_t style) const;
    /// That moves with a clip (as the clip column counts); 0: none does.
    [[nodiscard]] std::size_t gaitOf(std::size_t clip) const;
    /// How somebody moving at that speed comes to rest with one foot under the body, m/s²: standing
    /// still between two steps he would have to draw both feet in along the ground.
    [[nodiscard]] static float braking(const Gait& gait, double place, float metresPerSecond,
                                       float height);
    /// The place where the feet pass each other that is nearest to a place.
    [[nodiscard]] static double nearestTogether(const Gait& gait, double place);
    /// Whether the feet are about to pass each other: the moment to go over to another gait, since
    /// the foot on the ground is then under the body in both.
    [[nodiscard]] static bool isAboutToPass(const Gait& gait, double place);
    /// The same moment of a step in another gait.
    [[nodiscard]] static double placeInto(const Gait& from, const Gait& to, double place);
    /// Playback speed at which feet do not slide.
    [[nodiscard]] static float playback(const Gait& gait, float metresPerSecond, float height);

private:
    struct Candidate
    {
        Gait gait;
        model::ClipRole role = model::ClipRole::Other;
    };
    void addMovers(std::vector<Candidate> found);
    /// Speed at which one gait goes over into the next one up.
    [[nodiscard]] float border(std::size_t upper) const;

    /// Standing first, then by rising speed, then those that are only played where asked for.
    std::vector<Gait> m_gaits;
    std::size_t m_usual = 0; ///< how many of them are chosen by speed, standing among them
};

} // namespace crowd::behavior
