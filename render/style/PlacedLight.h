// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/CrowdFrame.h"
#include "model/scene/Scene.h"

namespace crowd::render {

/// Wider cones throw no shadows: too little would be left of a map in its middle.
inline constexpr float kWidestCasterRadians = 2.6F;

/// A light of the scene in linear light, as the shaders want it. World frame, metres.
struct PlacedLight
{
    glm::vec3 position{0.0F};
    glm::vec3 axis{0.0F}; ///< unit, from what it lights to the lamp; zero: it shines to all sides
    float edgeCosine = -1.0F; ///< where its cone ends
    float edgeSlope = 1.0F;   ///< brightness per cosine from there towards the middle
    glm::vec3 color{1.0F};    ///< on a surface that faces it a metre away
    float sizeMetres = 0.5F;  ///< what is nearer gets no brighter
    float coneRadians = 0.0F; ///< from edge to edge; 0: none
    float beam = 0.0F;        ///< share of it that is seen in the air
    float reach = 0.0F;       ///< metres to what it is turned to
    bool castsShadows = false;
};

/// Where those that are on shine to while it is dark or not, with people where a frame has them;
/// the strongest of them where they are more than model::kMostLightsDrawn. Those that aim at nobody
/// who is there are left out. First those that cast shadows, the strongest of those that are to, at
/// most model::kMostLightShadows: spotlights, then those that shine to all sides.
[[nodiscard]] std::vector<PlacedLight> placedLights(std::span<const model::Light> lights,
                                                    const model::CrowdFrame* frame, bool isDark);

/// How many of the first cast shadows, and how many of these first are spotlights.
struct LightCasters
{
    std::size_t all = 0;
    std::size_t spots = 0;
};
[[nodiscard]] LightCasters castersOf(std::span<const PlacedLight> lights);

} // namespace crowd::render
