// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "behavior/crowd/CrowdSimulation.h"

namespace crowd::behavior {

inline constexpr float kFreeSpeed = 1.34F; ///< metres a second of somebody alone (Weidmann 1993)

/// A closed corridor: two straights of `straight` metres joined by half circles; a ring when there
/// are no straights. Metres.
struct Track
{
    float straight = 0.0F;
    float radius = 10.0F; ///< of the middle line
    float width = 3.0F;

    [[nodiscard]] float area() const;
    [[nodiscard]] std::vector<Wall> walls() const;
    /// Unit vector along the corridor, anticlockwise seen from above with z up.
    [[nodiscard]] glm::vec2 along(const glm::vec2& at) const;
    /// Metres from the middle line, outwards.
    [[nodiscard]] float aside(const glm::vec2& at) const;
    /// In the middle two thirds of a straight; everywhere in a ring.
    [[nodiscard]] bool isMeasured(const glm::vec2& at) const;
    [[nodiscard]] float measuredArea() const;
    [[nodiscard]] std::vector<glm::vec2> places(std::size_t count, std::uint64_t seed) const;
};

/// People walking along a track, every other one against the rest where it is two-way.
class TrackCrowd
{
public:
    TrackCrowd(const Track& track, float perSquareMetre, bool isTwoWay, std::uint64_t seed);

    void step();
    /// Mean speed along the track and people per square metre, where it is measured.
    [[nodiscard]] glm::dvec2 speedAndDensity() const;
    /// How well directions are sorted across the width: 0 mixed, 1 in lanes (Yamori's band index
    /// over strips half a metre wide, each where it is measured).
    [[nodiscard]] double laneIndex() const;

private:
    [[nodiscard]] float signOf(std::size_t agent) const;

    Track m_track;
    bool m_isTwoWay;
    CrowdSimulation m_crowd;
};

} // namespace crowd::behavior
