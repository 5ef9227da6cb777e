// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "model/brush/PointerInput.h"

namespace crowd::model {

/// One application of a brush along the pointer's way.
struct Dab
{
    std::uint32_t index = 0; ///< counts from 0 within the stroke
    glm::ivec2 grid{0};      ///< position × kPointerGrid
    float pressure = 1.0F;   ///< a multiple of 1/4096
    double shownSeconds = 0.0;
    int points = 1; ///< spray: how many points fall in this tick

    [[nodiscard]] glm::dvec2 pixels() const { return pixelsOf(grid); }
};

/// Turns pointer inputs into dabs that do not depend on how the way was split into inputs: adding
/// grid points on the polyline, with time and pressure linear between, gives bit-identical dabs.
/// Straight runs are kept as whole-number directions from where they began, and the distance left
/// over at a bend is carried into the next run.
class Sampler
{
public:
    /// Dabs at the press and then every so many pixels of the way.
    [[nodiscard]] static Sampler alongWay(double spacingPixels);
    /// A dab at each 1/60 s of the stroke's own clock, with as many points as the rate has come to
    /// by then; the press gives one at once.
    [[nodiscard]] static Sampler spray(double pointsPerSecond, bool isRateByPressure);

    /// The dabs that the next input adds; the first input is the press.
    [[nodiscard]] std::vector<Dab> add(const PointerInput& input);

private:
    Sampler() = default;
    [[nodiscard]] Dab dabAt(glm::dvec2 pixels, const PointerInput& to, double share);
    void addAlongWay(const PointerInput& input, std::vector<Dab>& dabs);
    void addTicks(const PointerInput& input, std::vector<Dab>& dabs);

    double m_spacing = 0.0; ///< grid units; 0: by time
    double m_rate = 0.0;
    bool m_isRateByPressure = false;

    bool m_isPressed = false;
    PointerInput m_press;
    PointerInput m_last;
    std::uint32_t m_nextIndex = 0;
    // The straight run that the pointer is on.
    glm::ivec2 m_runStart{0};
    glm::ivec2 m_runStep{0};     ///< smallest whole-number step in its direction
    std::int64_t m_runSteps = 0; ///< taken so far
    double m_nextDistance = 0.0; ///< grid units from the start of the run to the next dab
    // The spray's clock.
    std::int64_t m_nextTick = 0;
    double m_points = 0.0; ///< the part of a point that has come together
};

} // namespace crowd::model
