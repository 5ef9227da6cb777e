// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/brush/BrushSettings.h"
#include "model/pick/StageRays.h"
#include "model/view/View.h"

/// The second step of a brush: how a value varies over the individuals of a dab. Randomness is a
/// pure function of the stroke's seed, the dab and the individual.
namespace crowd::model {

/// What a random value is for, so that the draws of one individual differ.
enum class DrawPurpose : std::uint8_t {
    Colour = 1,
    Heading,
    Clip,
    Phase,
    Speed,
    Template,
    Height,
    Girth,
    Palette,
    PointAngle,
    PointRadius,
    SeatShare,
    CellX,
    CellZ,
    Seed,
    DeleteShare,
    Outfit,
    Parts
};

[[nodiscard]] double randomUnit(std::uint64_t key, DrawPurpose purpose, std::uint64_t extra = 0);

/// Heading of the way between two points on screen as it runs on the surface under its end, on
/// the horizontal plane through it. Nothing without length or where the view looks into the sky.
[[nodiscard]] std::optional<float> headingOfLine(const View& view, const StageRays& stage,
                                                 const StrokeLine& line);

/// -pi..pi.
[[nodiscard]] float wrappedAngle(float radians);

/// Where somebody at `position` faces; `strokeHeading` for AlongStroke. u: the draw for Random,
/// 0..1. Nothing where the mode has no answer.
[[nodiscard]] std::optional<float> headingFor(const HeadingSettings& settings, const View& view,
                                              const glm::vec3& position,
                                              std::optional<float> strokeHeading, double u);

} // namespace crowd::model
