// SPDX-License-Identifier: MIT
#include "model/brush/PointerInput.h"

#include <cmath>

namespace crowd::model {

namespace {

/// Moves ties off the round fractions that times and positions like to have, so that the last bit
/// of an interpolation does not decide them.
constexpr double kTieBias = 1.0 / 1024.0;

} // namespace

glm::ivec2 gridPoint(glm::dvec2 pixels)
{
    const auto nearest = [](double value) {
        return static_cast<int>(std::floor(value * kPointerGrid + 0.5 + kTieBias));
    };
    return {nearest(pixels.x), nearest(pixels.y)};
}

PointerInput PointerInput::at(glm::dvec2 pixels, double timeSeconds, double shownSeconds)
{
    PointerInput input;
    input.grid = gridPoint(pixels);
    input.timeSeconds = timeSeconds;
    input.shownSeconds = shownSeconds;
    return input;
}

} // namespace crowd::model
