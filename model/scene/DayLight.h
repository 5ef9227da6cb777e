// SPDX-License-Identifier: MIT
#pragma once

#include "model/scene/Lighting.h"

/// Sun or moon, and the sky, of an hour of a day early in summer, halfway between equator and pole.
namespace crowd::model {

/// Replaces sun, sky and their colours, not the ground, the exposure or the haze; these colours are
/// paler, and the shadows softer, the more `lighting.haze` there is. `hours`: 0..24; others are
/// taken round the clock.
void setDayHours(Lighting& lighting, float hours);
/// The hour at which the sun stands so high, on its side of noon; at night, at which the moon
/// stands in that direction.
[[nodiscard]] float dayHours(const Lighting& lighting);

} // namespace crowd::model
