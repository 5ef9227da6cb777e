// SPDX-License-Identifier: MIT
#include "model/scene/lights/SpotLight.h"

#include <glm/geometric.hpp>

#include "model/scene/Light.h"

namespace crowd::model {

namespace {

constexpr float kSpotMetres = 7.0F; ///< above what it lights, and towards whoever looks
constexpr float kForward = 0.8F;    ///< shares of that towards him, and to his right
constexpr float kAside = 0.6F;
constexpr float kAimMetres = 0.6F; ///< it aims so far above the ground

} // namespace

void beginSpot(Light& light, const glm::vec3& lit, const glm::vec3& seenFrom)
{
    light.castsShadows = true;
    light.target = lit + glm::vec3(0.0F, kAimMetres, 0.0F);
    const glm::vec3 way = (seenFrom - lit) * glm::vec3(1.0F, 0.0F, 1.0F);
    const float length = glm::length(way);
    const glm::vec3 level = length > 0.01F ? way / length : glm::vec3(0.0F, 0.0F, 1.0F);
    // From one side: whoever looks sees lamp, beam and target apart.
    const glm::vec3 aside(level.z, 0.0F, -level.x);
    light.position =
        lit + kSpotMetres * (kForward * level + kAside * aside + glm::vec3(0.0F, 1.0F, 0.0F));
}

} // namespace crowd::model
