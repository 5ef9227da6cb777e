// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/base/Result.h"
#include "model/view/View.h"
#include "render/RenderInput.h"

namespace crowd::app {

/// Depth of field as people ask for it; without either, all of a picture is sharp.
struct LensWish
{
    std::optional<double> focusMetres; ///< from the camera; without: what it turns around
    std::optional<double> fStop;       ///< without: kUsualFStop
};

inline constexpr double kUsualFStop = 0.5;
inline constexpr double kLeastFStop = 0.01;
inline constexpr double kMostFStop = 1000.0;
inline constexpr double kLeastFocus = 0.01; ///< metres
inline constexpr double kMostFocus = 1e6;

/// The lens of a camera whose picture is 24 mm high, as of 35 mm film: focal length by its angle of
/// view, opening by focal length and f-stop. None where none is wished for. An error where a number
/// is none that can be, or the camera sees everything sharp.
[[nodiscard]] model::Result<std::optional<render::Lens>> lensOf(const LensWish& wish,
                                                                const model::Camera& camera);

} // namespace crowd::app
