// SPDX-License-Identifier: MIT
#include "model/brush/Sampler.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace crowd::model {

namespace {

constexpr double kTicksPerSecond = 60.0;
/// Interpolated values are rounded this coarsely, so that the last bits of the interpolation, which
/// do depend on the splitting, are lost.
constexpr double kValueGrid = 4096.0;
constexpr double kValueTieBias = 1.0 / 1024.0;

/// So much may be missing from a whole point for rounding.
constexpr double kPointTolerance = 1.0e-9;

double onValueGrid(double value)
{
    return std::floor(value * kValueGrid + 0.5 + kValueTieBias) / kValueGrid;
}

double between(double a, double b, double share)
{
    return a + (b - a) * share;
}

} // namespace

Sampler Sampler::alongWay(double spacingPixels)
{
    Sampler sampler;
    sampler.m_spacing = std::max(spacingPixels, 1.0 / kPointerGrid) * kPointerGrid;
    return sampler;
}

Sampler Sampler::spray(double pointsPerSecond, bool isRateByPressure)
{
    Sampler sampler;
    sampler.m_rate = std::max(pointsPerSecond, 0.0);
    sampler.m_isRateByPressure = isRateByPressure;
    return sampler;
}

Dab Sampler::dabAt(glm::dvec2 pixels, const PointerInput& to, double share)
{
    const double within = std::clamp(share, 0.0, 1.0);
    Dab dab;
    dab.index = m_nextIndex++;
    dab.grid = gridPoint(pixels);
    dab.pressure = static_cast<float>(onValueGrid(between(m_last.pressure, to.pressure, within)));
    dab.shownSeconds = onValueGrid(between(m_last.shownSeconds, to.shownSeconds, within));
    return dab;
}

std::vector<Dab> Sampler::add(const PointerInput& input)
{
    std::vector<Dab> dabs;
    if (!m_isPressed) {
        m_isPressed = true;
        m_press = input;
        m_last = input;
        dabs.push_back(dabAt(input.pixels(), input, 0.0));
        m_nextDistance = m_spacing;
        m_nextTick = 1;
        return dabs;
    }
    if (m_spacing > 0.0) {
        addAlongWay(input, dabs);
        m_last = input;
    } else {
        addTicks(input, dabs);
        const double time = std::max(input.timeSeconds, m_last.timeSeconds);
        m_last = input;
        m_last.timeSeconds = time;
    }
    return dabs;
}

void Sampler::addAlongWay(const PointerInput& input, std::vector<Dab>& dabs)
{
    const glm::ivec2 way = input.grid - m_last.grid;
    if (way == glm::ivec2(0)) {
        return;
    }
    const int steps = std::gcd(way.x, way.y);
    const glm::ivec2 step = way / steps;
    const auto lengthOf = [](glm::ivec2 v) {
        return std::sqrt(static_cast<double>(v.x) * v.x + static_cast<double>(v.y) * v.y);
    };
    if (step != m_runStep) {
        m_nextDistance -= static_cast<double>(m_runSteps) * lengthOf(m_runStep);
        m_runStart = m_last.grid;
        m_runStep = step;
        m_runSteps = 0;
    }
    const auto before = static_cast<double>(m_runSteps);
    m_runSteps += steps;
    const double stepLength = lengthOf(step);
    const double end = static_cast<double>(m_runSteps) * stepLength;
    for (; m_nextDistance <= end; m_nextDistance += m_spacing) {
        const double at = m_nextDistance / stepLength;
        const glm::dvec2 grid = glm::dvec2(m_runStart) + glm::dvec2(step) * at;
        dabs.push_back(dabAt(grid / static_cast<double>(kPointerGrid), input,
                             (at - before) / static_cast<double>(steps)));
    }
}

void Sampler::addTicks(const PointerInput& input, std::vector<Dab>& dabs)
{
    const double end = std::max(input.timeSeconds, m_last.timeSeconds);
    for (;; ++m_nextTick) {
        const double time = m_press.timeSeconds + static_cast<double>(m_nextTick) / kTicksPerSecond;
        if (time > end) {
            return;
        }
        const double span = end - m_last.timeSeconds;
        const double share = span > 0.0 ? (time - m_last.timeSeconds) / span : 1.0;
        const glm::dvec2 from = m_last.pixels();
        Dab dab = dabAt(from + (input.pixels() - from) * std::clamp(share, 0.0, 1.0), input, share);
        m_points += m_rate * (m_isRateByPressure ? dab.pressure : 1.0) / kTicksPerSecond;
        const double whole = std::floor(m_points + kPointTolerance);
        m_points -= whole;
        dab.points = static_cast<int>(whole);
        dabs.push_back(dab);
    }
}

} // namespace crowd::model
