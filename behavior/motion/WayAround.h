// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "behavior/crowd/Body.h"
#include "behavior/surface/WalkSurface.h"

namespace crowd::behavior {

/// One agent's way over a surface around what stands between it and its aim: corners that it goes
/// to one after the other. Looked for when the aim changes, and again where others have pushed the
/// agent off. Metres, world frame.
class WayAround
{
public:
    /// The next question looks for the way anew.
    void forget();
    /// The first check comes after so many steps, so that not everybody checks in the same one.
    void setStepsToCheck(std::uint32_t steps) { m_stepsToCheck = steps; }
    /// Vector to walk along now, to an aim or to the next corner of the way to it.
    [[nodiscard]] glm::vec2 towards(const WalkSurface& surface, const Body& body, float height,
                                    const glm::vec3& aim, const Lane& lane);
    /// Whether the way to an aim ends elsewhere, as near as one gets, and within so many metres of
    /// a point. False before the way to that aim was looked for.
    [[nodiscard]] bool endsShort(const glm::vec2& aim, const glm::vec2& from, float metres) const;
    /// Null: it goes straight on.
    [[nodiscard]] const glm::vec3* nextCorner() const
    {
        return m_corners.empty() ? nullptr : &m_corners.back();
    }

private:
    void passCorners(const glm::vec3& at);
    void check(const WalkSurface& surface, const glm::vec3& at);

    static constexpr glm::vec2 kNoAim{1e30F};
    std::vector<glm::vec3> m_corners; ///< still to come, the next one last
    glm::vec2 m_aim = kNoAim;         ///< that they lead to
    glm::vec2 m_before{0.0F};         ///< corner passed last, or where it began
    std::uint32_t m_stepsAstray = 0;  ///< without getting nearer
    std::uint32_t m_stepsToCheck = 0; ///< whether it is still its way
};

} // namespace crowd::behavior
