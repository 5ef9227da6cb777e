// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/Light.h"

/// What rules make of the lights of a scene while it plays. Plain values; seconds of the run.
namespace crowd::model {

/// What a rule tells a light to do.
enum class LightDeed : std::uint8_t { On, Off, Flash, Sweep };

/// What one light was told: to become brighter or darker, to flash, to sweep. All at once, if so.
struct LightCue
{
    LightId light = 0;
    float from = 1.0F; ///< share of its strength before
    float to = 1.0F;   ///< and after
    double fadeBegin = 0.0;
    float fadeSeconds = 0.0F;
    double flashBegin = 0.0;
    float flashSeconds = 0.0F; ///< 0: it does not
    double sweepBegin = 0.0;
    float sweepSeconds = 0.0F; ///< 0: it does not
    friend bool operator==(const LightCue&, const LightCue&) = default;
};

/// Of those that were told something, each once.
using LightCues = std::vector<LightCue>;

/// From this moment on. Of what a light does already, being told again changes nothing: each of a
/// crowd may say it.
void tellLight(LightCues& cues, const Light& light, LightDeed deed, float seconds, double now);

/// How a light is at one moment.
struct LightNow
{
    float share = 1.0F;       ///< of its strength; 0: it is off
    float turnRadians = 0.0F; ///< from where it aims, around the vertical through its lamp
};

/// `cues`: null, or none of that light: as the scene has it.
[[nodiscard]] LightNow lightNow(const Light& light, const LightCues* cues, double now);
/// What it is turned to then.
[[nodiscard]] glm::vec3 turnedAim(const Light& light, const glm::vec3& target, float turnRadians);

} // namespace crowd::model
