// SPDX-License-Identifier: MIT
#include "app/pictures/LensWish.h"

#include <algorithm>
#include <cmath>

namespace crowd::app {

namespace {

constexpr double kFilmHeight = 0.024; ///< metres

/// Not a number is in none.
bool isWithin(double value, double low, double high)
{
    return value >= low && value <= high;
}

} // namespace

model::Result<std::optional<render::Lens>> lensOf(const LensWish& wish, const model::Camera& camera)
{
    if (!wish.focusMetres && !wish.fStop) {
        return std::optional<render::Lens>();
    }
    if (camera.projection == model::Projection::Orthographic) {
        return model::Error{QT_TRANSLATE_NOOP(
            "Messages", "An orthographic camera has no lens: everything is sharp. Take a camera "
                        "with perspective, or leave out depth of field.")};
    }
    const double focus =
        wish.focusMetres.value_or(std::max(static_cast<double>(camera.pivotDistance), kLeastFocus));
    if (!isWithin(focus, kLeastFocus, kMostFocus)) {
        return model::Error{QT_TRANSLATE_NOOP(
            "Messages", "The distance of focus must be from 0.01 to 1000000 metres.")};
    }
    const double fStop = wish.fStop.value_or(kUsualFStop);
    if (!isWithin(fStop, kLeastFStop, kMostFStop)) {
        return model::Error{QT_TRANSLATE_NOOP(
            "Messages", "The f-stop must be from 0.01 to 1000; the smaller, the less is sharp.")};
    }
    const double focalLength =
        kFilmHeight / 2.0 / std::tan(static_cast<double>(camera.fovYRadians) / 2.0);
    return std::optional(
        render::Lens{static_cast<float>(focus), static_cast<float>(focalLength / fStop / 2.0)});
}

} // namespace crowd::app
