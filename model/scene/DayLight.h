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
/// Makes sun and sky paler, or less so, where they are still as the hour made them in the haze that
/// there was before.
void followHaze(Lighting& lighting, const Lighting& before);
/// Sun and sky give so little to level ground that lamps go on, as they do at dusk.
[[nodiscard]] bool isDark(const Lighting& lighting);

} // namespace crowd::model
