// SPDX-License-Identifier: MIT
#include "render/style/Style.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "model/base/Color.h"

namespace crowd::render {

namespace {

/// Where the sun stands too low, shadows would reach to the end of the world.
bool isCasting(const model::Lighting& light)
{
    constexpr float kLowest = 0.02F; // sine
    return light.shadowStrength > 0.0F && light.sunStrength > 0.0F &&
           std::sin(light.sunElevationRadians) > kLowest;
}

} // namespace

Style Style::of(const RenderInput& input)
{
    const LookInfo& look = lookInfo(input.look);
    Style style;
    style.surfaceDefines = look.defines;
    style.light = LinearLight::from(input.lighting);
    style.hasSky = input.background.w <= 0.0F && !input.isTransparent;
    style.hasGround = input.showGround && !input.isTransparent;
    style.hasGrid = input.lighting.showGroundGrid;
    if (look.isLit) {
        style.lights = placedLights(input.lights, input.frame.get());
        style.tone = Tone::from(input.lighting);
        style.inkPixels = look.inkPixels;
        // Soft darkness is not drawn with ink.
        const bool isSoft = input.showShadows && look.inkPixels <= 0.0F;
        style.occlusion = isSoft ? input.lighting.occlusion : 0.0F;
    }
    if (!style.lights.empty()) {
        style.surfaceDefines += "LIGHTS=" + std::to_string(style.lights.size()) + ' ';
    }
    style.surfaceDefines += style.tone.hazePerMetre > 0.0F ? "HAZY " : "";
    style.surfaceDefines += style.tone.defines();
    style.clearColor = style.hasSky ? style.tone.of(style.light.horizon)
                                    : model::linearFromSrgb(glm::vec3(input.background));
    style.groundColor =
        style.light.ground * (look.isLit ? style.light.onGround() : glm::vec3(1.0F));
    style.blobStrength = input.showShadows ? style.blobStrength : 0.0F;
    if (look.isLit && input.showShadows && isCasting(input.lighting)) {
        style.shadowStrength = input.lighting.shadowStrength;
        style.shadowSoftness = input.lighting.shadowSoftnessRadians;
    }
    if (style.inkPixels > 0.0F && style.castsShadows()) {
        style.blobStrength = 0.0F;
    }
    style.selectionColor = input.selectionColor;
    return style;
}

glm::vec3 Style::shadowTint() const
{
    constexpr glm::vec3 kLuminance(0.2126F, 0.7152F, 0.0722F);
    const auto hue = [&](const glm::vec3& color) {
        return color / std::max(glm::dot(color, kLuminance), 1e-4F);
    };
    return hue(light.sky) / glm::max(hue(light.onGround()), glm::vec3(1e-4F));
}

} // namespace crowd::render
