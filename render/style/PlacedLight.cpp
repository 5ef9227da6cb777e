// SPDX-License-Identifier: MIT
#include "render/style/PlacedLight.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "model/base/Color.h"
#include "model/scene/LightAim.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr float kSharpest = 0.004F; ///< share of the cone in which even a sharp edge fades

/// One that shines, as rules have it at this moment.
struct ShiningLight
{
    Light light;
    float turnRadians = 0.0F;
};

std::vector<ShiningLight> shining(std::span<const Light> lights, const CrowdFrame* frame,
                                  bool isDark)
{
    std::vector<ShiningLight> on;
    for (const Light& light : lights) {
        const LightNow now = frame != nullptr
                                 ? lightNow(light, frame->lightCues.get(), frame->seconds)
                                 : lightNow(light, nullptr, 0.0);
        const bool isTime = isDark || !light.isOnlyAfterDark;
        if (isTime && now.share > 0.0F && light.strength > 0.0F) {
            on.push_back({light, now.turnRadians});
            on.back().light.strength *= now.share;
        }
    }
    if (on.size() > kMostLightsDrawn) {
        std::ranges::stable_sort(on, std::ranges::greater(),
                                 [](const ShiningLight& each) { return each.light.strength; });
        on.erase(on.begin() + kMostLightsDrawn, on.end());
    }
    return on;
}

PlacedLight placed(const Light& light, const glm::vec3& target)
{
    PlacedLight made;
    made.position = light.position;
    const glm::vec3 srgb =
        glm::vec3(light.color[0], light.color[1], light.color[2]) * (1.0F / 255.0F);
    made.color = linearFromSrgb(srgb) * (light.strength * kLightMetres * kLightMetres);
    made.sizeMetres = light.sizeMetres;
    made.castsShadows = light.castsShadows;
    if (!isAimed(light)) {
        return made;
    }
    const glm::vec3 back = light.position - target;
    const float length = glm::length(back);
    made.coneRadians = light.coneRadians;
    made.beam = light.beam;
    made.reach = length;
    made.castsShadows = made.castsShadows && light.coneRadians <= kWidestCasterRadians;
    made.axis = length > 1e-4F ? back / length : glm::vec3(0.0F, 1.0F, 0.0F);
    const float half = light.coneRadians * 0.5F;
    made.edgeCosine = std::cos(half);
    const float full = std::cos(half * (1.0F - std::max(light.softness, kSharpest)));
    made.edgeSlope = 1.0F / std::max(full - made.edgeCosine, 1e-6F);
    return made;
}

void castersFirst(std::vector<PlacedLight>& lights)
{
    const auto strength = [](const PlacedLight& light) {
        return light.castsShadows ? glm::dot(light.color, glm::vec3(1.0F)) : -1.0F;
    };
    std::ranges::stable_sort(lights, std::ranges::greater(), strength);
    for (std::size_t i = kMostLightShadows; i < lights.size(); ++i) {
        lights[i].castsShadows = false;
    }
    const auto isOfSpot = [](const PlacedLight& light) {
        return light.castsShadows && light.coneRadians > 0.0F;
    };
    std::ranges::stable_sort(lights, std::ranges::greater(), [&isOfSpot](const PlacedLight& light) {
        return 2 * static_cast<int>(isOfSpot(light)) + static_cast<int>(light.castsShadows);
    });
}

} // namespace

std::vector<PlacedLight> placedLights(std::span<const Light> lights, const CrowdFrame* frame,
                                      bool isDark)
{
    std::vector<PlacedLight> made;
    for (const ShiningLight& each : shining(lights, frame, isDark)) {
        if (const auto target = aimedAt(each.light, frame)) {
            made.push_back(placed(each.light, turnedAim(each.light, *target, each.turnRadians)));
        }
    }
    castersFirst(made);
    return made;
}

LightCasters castersOf(std::span<const PlacedLight> lights)
{
    LightCasters casters;
    for (const PlacedLight& light : lights) {
        casters.all += light.castsShadows ? 1 : 0;
        casters.spots += light.castsShadows && light.coneRadians > 0.0F ? 1 : 0;
    }
    return casters;
}

} // namespace crowd::render
