// SPDX-License-Identifier: MIT
#include "model/scene/ReadyLight.h"

#include <algorithm>
#include <array>

namespace crowd::model {

namespace {

constexpr float kRadians = 0.017453292F;

/// Colours sRGB 0..255, as they are chosen.
constexpr glm::vec3 srgb(int red, int green, int blue)
{
    return glm::vec3(red, green, blue) / 255.0F;
}

struct Sun
{
    float azimuthDegrees;
    float elevationDegrees;
    glm::vec3 color;
    float strength;
    float shadowStrength;
    float softnessDegrees;
};

struct Sky
{
    glm::vec3 light;
    float strength;
    glm::vec3 zenith;
    glm::vec3 horizon;
};

Lighting lightOf(const Sun& sun, const Sky& sky)
{
    Lighting light;
    light.sunAzimuthRadians = sun.azimuthDegrees * kRadians;
    light.sunElevationRadians = sun.elevationDegrees * kRadians;
    light.sunColor = sun.color;
    light.sunStrength = sun.strength;
    light.shadowStrength = sun.shadowStrength;
    light.shadowSoftnessRadians = sun.softnessDegrees * kRadians;
    light.occlusion = 0.6F;
    light.highlights = 1.0F;
    light.ambientColor = sky.light;
    light.ambientStrength = sky.strength;
    light.skyZenith = sky.zenith;
    light.skyHorizon = sky.horizon;
    return light;
}

} // namespace

std::span<const ReadyLight> readyLights()
{
    static const std::array kReady{
        ReadyLight{"noon", QT_TRANSLATE_NOOP("Fields", "Noon"),
                   lightOf({25.0F, 62.0F, srgb(255, 249, 236), 1.1F, 0.85F, 1.0F},
                           {srgb(158, 184, 220), 0.45F, srgb(74, 124, 196), srgb(196, 216, 234)})},
        ReadyLight{"afternoon", QT_TRANSLATE_NOOP("Fields", "Afternoon"),
                   lightOf({52.0F, 32.0F, srgb(255, 226, 180), 1.15F, 0.85F, 1.2F},
                           {srgb(158, 176, 208), 0.42F, srgb(88, 134, 196), srgb(226, 216, 196)})},
        ReadyLight{"dusk", QT_TRANSLATE_NOOP("Fields", "Dusk"),
                   lightOf({78.0F, 9.0F, srgb(255, 158, 92), 1.0F, 0.8F, 2.0F},
                           {srgb(134, 134, 178), 0.42F, srgb(62, 76, 130), srgb(236, 166, 124)})},
        ReadyLight{"overcast", QT_TRANSLATE_NOOP("Fields", "Overcast"),
                   lightOf({30.0F, 55.0F, srgb(235, 240, 245), 0.25F, 0.6F, 8.0F},
                           {srgb(206, 212, 220), 0.85F, srgb(150, 160, 172), srgb(202, 208, 214)})},
        ReadyLight{"night", QT_TRANSLATE_NOOP("Fields", "Night"),
                   lightOf({-40.0F, 40.0F, srgb(150, 176, 230), 0.24F, 0.8F, 1.0F},
                           {srgb(84, 100, 150), 0.26F, srgb(8, 12, 28), srgb(30, 38, 62)})},
        ReadyLight{"studio", QT_TRANSLATE_NOOP("Fields", "Studio"),
                   lightOf({35.0F, 48.0F, srgb(255, 252, 248), 0.85F, 0.55F, 6.0F},
                           {srgb(226, 232, 240), 0.7F, srgb(206, 210, 214), srgb(232, 234, 236)})}};
    return kReady;
}

const ReadyLight* findReadyLight(std::string_view key)
{
    const auto ready = readyLights();
    const auto found = std::ranges::find(ready, key, &ReadyLight::key);
    return found != ready.end() ? &*found : nullptr;
}

Lighting litAs(const ReadyLight& ready, const Lighting& now)
{
    Lighting light = ready.light;
    light.ground = now.ground;
    light.showGroundGrid = now.showGroundGrid;
    light.unknownMembers = now.unknownMembers;
    return light;
}

} // namespace crowd::model
