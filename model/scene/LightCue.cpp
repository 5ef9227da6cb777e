// SPDX-License-Identifier: MIT
#include "model/scene/LightCue.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crowd::model {

namespace {

constexpr float kFlashShare = 3.0F;      ///< of its strength, on top
constexpr float kSweepRadians = 0.6F;    ///< to each side
constexpr float kShortestSeconds = 0.1F; ///< shorter ones would fall between two pictures

/// Share of what takes so long that has passed; 1 where it is over, or does not happen.
float passed(double begin, float seconds, double now)
{
    if (seconds <= 0.0F) {
        return 1.0F;
    }
    const double share = (now - begin) / static_cast<double>(seconds);
    return static_cast<float>(std::clamp(share, 0.0, 1.0));
}

float fadedShare(const LightCue& cue, double now)
{
    return std::lerp(cue.from, cue.to, passed(cue.fadeBegin, cue.fadeSeconds, now));
}

LightCue& cueFor(LightCues& cues, const Light& light)
{
    const auto found = std::ranges::find(cues, light.id, &LightCue::light);
    if (found != cues.end()) {
        return *found;
    }
    LightCue fresh;
    fresh.light = light.id;
    fresh.from = fresh.to = light.isOn ? 1.0F : 0.0F;
    cues.push_back(fresh);
    return cues.back();
}

void fade(LightCue& cue, float to, float seconds, double now)
{
    if (cue.to == to) {
        return;
    }
    cue.from = fadedShare(cue, now);
    cue.to = to;
    cue.fadeBegin = now;
    cue.fadeSeconds = seconds;
}

} // namespace

void tellLight(LightCues& cues, const Light& light, LightDeed deed, float seconds, double now)
{
    LightCue& cue = cueFor(cues, light);
    const float least = std::max(seconds, kShortestSeconds);
    switch (deed) {
    case LightDeed::On:
        fade(cue, 1.0F, seconds, now);
        break;
    case LightDeed::Off:
        fade(cue, 0.0F, seconds, now);
        break;
    case LightDeed::Flash:
        if (passed(cue.flashBegin, cue.flashSeconds, now) >= 1.0F) {
            cue.flashBegin = now;
            cue.flashSeconds = least;
        }
        break;
    case LightDeed::Sweep:
        if (passed(cue.sweepBegin, cue.sweepSeconds, now) >= 1.0F) {
            cue.sweepBegin = now;
            cue.sweepSeconds = least;
        }
        break;
    }
}

LightNow lightNow(const Light& light, const LightCues* cues, double now)
{
    LightNow state{light.isOn ? 1.0F : 0.0F};
    if (cues == nullptr) {
        return state;
    }
    const auto cue = std::ranges::find(*cues, light.id, &LightCue::light);
    if (cue == cues->end()) {
        return state;
    }
    const float left = 1.0F - passed(cue->flashBegin, cue->flashSeconds, now);
    state.share = fadedShare(*cue, now) + kFlashShare * left * left;
    const float way = passed(cue->sweepBegin, cue->sweepSeconds, now);
    state.turnRadians =
        way < 1.0F ? kSweepRadians * std::sin(2.0F * std::numbers::pi_v<float> * way) : 0.0F;
    return state;
}

glm::vec3 turnedAim(const Light& light, const glm::vec3& target, float turnRadians)
{
    const glm::vec3 way = target - light.position;
    const float cosine = std::cos(turnRadians);
    const float sine = std::sin(turnRadians);
    return light.position +
           glm::vec3(cosine * way.x + sine * way.z, way.y, cosine * way.z - sine * way.x);
}

} // namespace crowd::model
