// SPDX-License-Identifier: MIT
#include "model/scene/lights/PointLight.h"

#include "model/scene/Light.h"

namespace crowd::model {

namespace {

constexpr float kPointMetres = 2.5F;   ///< above the ground
constexpr float kPointStrength = 0.1F; ///< it is near what it lights

} // namespace

void beginPoint(Light& light, const glm::vec3& lit, const glm::vec3& /*seenFrom*/)
{
    light.target = lit;
    light.strength = kPointStrength;
    light.position = lit + glm::vec3(0.0F, kPointMetres, 0.0F);
}

} // namespace crowd::model
