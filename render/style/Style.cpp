// SPDX-License-Identifier: MIT
#include "render/style/Style.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "model/base/Color.h"
#include "model/scene/DayLight.h"

namespace crowd::render {

namespace {

/// Where the sun stands too low, shadows would reach to the end of the world.
bool isCasting(const model::Lighting& light)
{
    constexpr float kLowest = 0.02F; // sine
    return light.shadowStrength > 0.0F && light.sunStrength > 0.0F &&
           std::sin(light.sunElevationRadians) > kLowest;
}

glm::vec3 linearOf(std::uint32_t rgb)
{
    const glm::vec3 srgb(static_cast<float>(rgb >> 16U & 0xFFU),
                         static_cast<float>(rgb >> 8U & 0xFFU), static_cast<float>(rgb & 0xFFU));
    return model::linearFromSrgb(srgb * (1.0F / 255.0F));
}

/// White light from one side, just so much that shapes are seen.
model::Lighting evenLight(const model::Lighting& scene)
{
    model::Lighting light;
    light.sunColor = light.ambientColor = glm::vec3(1.0F);
    light.sunStrength = 0.5F;
    light.ambientStrength = 0.65F;
    light.showGroundGrid = scene.showGroundGrid;
    return light;
}

/// `skyShare`: of a bright sky that is seen at this hour.
void usePaint(Style& style, const LookPaint& paint, float skyShare)
{
    style.paint = Style::Paint{linearOf(paint.people), linearOf(paint.stage)};
    style.surfaceDefines += "PAINTED ";
    style.light.ground = linearOf(paint.ground);
    style.light.horizon = style.light.zenith = linearOf(paint.sky) * skyShare;
    style.inkColor = linearOf(paint.ink);
}

void useLight(Style& style, const RenderInput& input, const LookInfo& look,
              const model::Lighting& lighting)
{
    if (!look.isByProperty) {
        style.lights = placedLights(input.lights, input.frame.get(), isDark(lighting));
    }
    style.tone = Tone::from(lighting);
    // Soft darkness is not drawn with ink.
    const bool hasInk = style.inkPixels > 0.0F;
    style.occlusion = input.showShadows && !hasInk ? lighting.occlusion : 0.0F;
    style.hasRelief = look.paint == nullptr && look.inkPixels <= 0.0F;
    // Clay is dull, and ink has its own way to say that something shines.
    style.highlights = look.paint == nullptr && !hasInk ? lighting.highlights : 0.0F;
}

} // namespace

Style Style::of(const RenderInput& input)
{
    const LookInfo& look = lookInfo(input.look);
    const model::Lighting lighting = look.isByProperty ? evenLight(input.lighting) : input.lighting;
    Style style;
    style.surfaceDefines = look.defines;
    style.surfaceDefines += input.isTwoTone && input.look == Look::Cartoon ? "TWO_TONES " : "";
    style.light = LinearLight::from(lighting);
    style.inkPixels = input.ink ? input.ink->pixels : look.inkPixels;
    style.isWire = look.isWire;
    style.hasCards = !look.isWire;
    if (look.paint != nullptr) {
        const glm::vec3 ground = style.light.onGround();
        const float level = std::max({ground.x, ground.y, ground.z});
        usePaint(style, *look.paint, look.isLit ? std::min(level, 1.0F) : 1.0F);
    }
    style.hasSky = input.background.w <= 0.0F && !input.isTransparent;
    style.hasGround = input.showGround && !input.isTransparent;
    style.hasGrid = lighting.showGroundGrid;
    if (look.isLit) {
        useLight(style, input, look, lighting);
    }
    if (input.showShadows) {
        style.casters = castersOf(style.lights);
    }
    if (!style.lights.empty()) {
        style.surfaceDefines += "LIGHTS=" + std::to_string(style.lights.size()) + ' ';
    }
    style.surfaceDefines += style.tone.hazeDefines();
    style.surfaceDefines += style.tone.defines();
    style.clearColor = style.hasSky ? style.tone.of(style.light.horizon)
                                    : model::linearFromSrgb(glm::vec3(input.background));
    style.groundColor =
        style.light.ground * (look.isLit ? style.light.onGround() : glm::vec3(1.0F));
    const bool isFlat = look.paint != nullptr && !look.isLit;
    style.blobStrength = input.showShadows && !isFlat ? style.blobStrength : 0.0F;
    if (look.isLit && input.showShadows && isCasting(lighting)) {
        style.shadowStrength = lighting.shadowStrength;
        style.shadowSoftness = lighting.shadowSoftnessRadians;
    }
    if (style.inkPixels > 0.0F && style.castsShadows()) {
        style.blobStrength = 0.0F;
    }
    if (input.ink) {
        style.inkColor = model::linearFromSrgb(input.ink->color);
    }
    style.selectionColor = input.selectionColor;
    return style;
}

Style Style::ofAovs(const RenderInput& input)
{
    Style style;
    style.surfaceDefines = input.earlier ? "AOV MOTION " : "AOV ";
    style.hasRelief = true;
    style.hasCards = false;
    style.hasGround = input.showGround && !input.isTransparent;
    style.hasGrid = false;
    return style;
}

std::string Style::materialDefines() const
{
    return surfaceDefines + (highlights > 0.0F ? "HIGHLIGHTS " : "");
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
