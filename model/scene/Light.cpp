// SPDX-License-Identifier: MIT
#include "model/scene/Light.h"

#include <algorithm>
#include <array>
#include <limits>

namespace crowd::model {

namespace {

using Begin = void (*)(Light&, const glm::vec3& lit, const glm::vec3& seenFrom);
constexpr std::array<Begin, kLightKinds.size()> kBegins{beginSpot, beginPoint}; ///< of each kind

} // namespace

Light newLight(LightKind kind, const glm::vec3& lit, const glm::vec3& seenFrom)
{
    Light light;
    light.kind = kind;
    kBegins[static_cast<std::size_t>(kind)](light, lit, seenFrom);
    return light;
}

const Light* findLight(const Lights& lights, LightId id)
{
    const auto found = std::ranges::find(lights, id, &Light::id);
    return found == lights.end() ? nullptr : &*found;
}

LightId freeLightId(const Lights& lights, LightId taken)
{
    LightId last = taken;
    for (const Light& each : lights) {
        last = std::max(last, each.id);
    }
    const bool isFull = lights.size() >= kMostLights || last == std::numeric_limits<LightId>::max();
    return isFull ? 0 : last + 1;
}

} // namespace crowd::model
