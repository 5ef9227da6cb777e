// SPDX-License-Identifier: MIT
#include "model/scene/Light.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace crowd::model {

namespace {

constexpr float kSpotMetres = 7.0F; ///< above what it lights, and towards whoever looks
constexpr float kForward = 0.8F;    ///< shares of that towards him, and to his right
constexpr float kAside = 0.6F;
constexpr float kAimMetres = 0.6F;     ///< it aims so far above the ground
constexpr float kPointMetres = 2.5F;   ///< above the ground
constexpr float kPointStrength = 0.1F; ///< it is near what it lights

} // namespace

Light newLight(LightKind kind, const glm::vec3& lit, const glm::vec3& seenFrom)
{
    Light light;
    light.kind = kind;
    light.target = lit;
    if (kind == LightKind::Point) {
        light.strength = kPointStrength;
        light.position = lit + glm::vec3(0.0F, kPointMetres, 0.0F);
        return light;
    }
    light.castsShadows = true;
    light.target.y += kAimMetres;
    const glm::vec3 way = (seenFrom - lit) * glm::vec3(1.0F, 0.0F, 1.0F);
    const float length = glm::length(way);
    const glm::vec3 level = length > 0.01F ? way / length : glm::vec3(0.0F, 0.0F, 1.0F);
    // From one side: whoever looks sees lamp, beam and target apart.
    const glm::vec3 aside(level.z, 0.0F, -level.x);
    light.position =
        lit + kSpotMetres * (kForward * level + kAside * aside + glm::vec3(0.0F, 1.0F, 0.0F));
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
