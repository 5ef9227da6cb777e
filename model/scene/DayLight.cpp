// SPDX-License-Identifier: MIT
#include "model/scene/DayLight.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace crowd::model {

namespace {

constexpr float kTurn = 6.2831853F;
constexpr float kDegree = kTurn / 360.0F;
constexpr float kHoursADay = 24.0F;
constexpr float kLatitude = 45.0F * kDegree;
constexpr float kDeclination = 20.0F * kDegree; ///< of the sun, late in May
constexpr float kDarkHorizon = 0.45F;           ///< a sky that is darker there is the night's
constexpr float kMoonDegrees = -8.0F;           ///< of the sun, when the moon begins to shine
constexpr float kAfterglowDegrees = -3.0F;      ///< of the sun, when its colour stays
constexpr float kLowestSun = 1.0F * kDegree;
constexpr float kLowestMoon = 18.0F * kDegree;
constexpr float kGrey = 0.8F; ///< of the way that the densest haze goes towards it

/// sRGB 0..255.
constexpr glm::vec3 dayColor(int red, int green, int blue)
{
    return glm::vec3(red, green, blue) / 255.0F;
}

/// What the sky is like while the sun stands so high.
struct SkyAt
{
    float elevationDegrees;
    glm::vec3 sun;
    float sunStrength;
    glm::vec3 light;
    float lightStrength;
    glm::vec3 zenith;
    glm::vec3 horizon;
};

/// Ascending. By day as the ready-made lights have it; below -8 degrees it is the moon that shines.
constexpr std::array kSkies{
    SkyAt{-14.0F, dayColor(150, 176, 230), 0.24F, dayColor(84, 100, 150), 0.26F,
          dayColor(8, 12, 28), dayColor(30, 38, 62)},
    SkyAt{kMoonDegrees, dayColor(150, 176, 230), 0.02F, dayColor(98, 110, 172), 0.4F,
          dayColor(22, 32, 76), dayColor(82, 80, 116)},
    SkyAt{kAfterglowDegrees, dayColor(255, 120, 70), 0.12F, dayColor(108, 110, 166), 0.4F,
          dayColor(34, 45, 92), dayColor(166, 104, 104)},
    SkyAt{1.0F, dayColor(255, 126, 66), 0.6F, dayColor(118, 116, 164), 0.37F, dayColor(48, 60, 110),
          dayColor(226, 142, 108)},
    SkyAt{9.0F, dayColor(255, 158, 92), 1.0F, dayColor(134, 134, 178), 0.42F, dayColor(62, 76, 130),
          dayColor(236, 166, 124)},
    SkyAt{32.0F, dayColor(255, 226, 180), 1.15F, dayColor(158, 176, 208), 0.42F,
          dayColor(88, 134, 196), dayColor(226, 216, 196)},
    SkyAt{62.0F, dayColor(255, 249, 236), 1.1F, dayColor(158, 184, 220), 0.45F,
          dayColor(74, 124, 196), dayColor(196, 216, 234)}};

SkyAt skyAt(float elevationDegrees)
{
    const auto* above = std::ranges::lower_bound(kSkies, elevationDegrees, std::ranges::less(),
                                                 &SkyAt::elevationDegrees);
    if (above == kSkies.begin()) {
        return kSkies.front();
    }
    if (above == kSkies.end()) {
        return kSkies.back();
    }
    const SkyAt& b = *above;
    const SkyAt& a = *(above - 1);
    const float share =
        (elevationDegrees - a.elevationDegrees) / (b.elevationDegrees - a.elevationDegrees);
    return {elevationDegrees,
            glm::mix(a.sun, b.sun, share),
            glm::mix(a.sunStrength, b.sunStrength, share),
            glm::mix(a.light, b.light, share),
            glm::mix(a.lightStrength, b.lightStrength, share),
            glm::mix(a.zenith, b.zenith, share),
            glm::mix(a.horizon, b.horizon, share)};
}

/// Azimuth from the south, +Z, towards the west, +X, and elevation; the common formula of a
/// star's horizontal coordinates. `turned`: its hour angle.
glm::vec2 placeOf(float turned)
{
    const float high = std::sin(kLatitude) * std::sin(kDeclination) +
                       std::cos(kLatitude) * std::cos(kDeclination) * std::cos(turned);
    const float azimuth =
        std::atan2(std::sin(turned), std::cos(turned) * std::sin(kLatitude) -
                                         std::tan(kDeclination) * std::cos(kLatitude));
    return {azimuth, std::asin(std::clamp(high, -1.0F, 1.0F))};
}

float wrapped(float value, float round)
{
    return value - round * std::floor(value / round);
}

/// The hour angle of an azimuth of -pi..pi; it grows with it.
float turnedAt(float azimuth)
{
    float low = -kTurn / 2.0F;
    float high = kTurn / 2.0F;
    for (int i = 0; i < 30; ++i) {
        const float middle = (low + high) / 2.0F;
        (placeOf(middle).x < azimuth ? low : high) = middle;
    }
    return (low + high) / 2.0F;
}

/// The hour angle after noon at which the sun stands so high, or as near as it comes to that.
float turnedTo(float elevation)
{
    const float share = (std::sin(elevation) - std::sin(kLatitude) * std::sin(kDeclination)) /
                        (std::cos(kLatitude) * std::cos(kDeclination));
    return std::acos(std::clamp(share, -1.0F, 1.0F));
}

void addHaze(Lighting& light)
{
    const float share = light.haze * light.haze;
    const float level = glm::dot(light.skyHorizon, glm::vec3(0.3F, 0.5F, 0.2F));
    light.skyHorizon = glm::mix(light.skyHorizon, glm::vec3(level), share * kGrey);
    light.skyZenith = glm::mix(light.skyZenith, light.skyHorizon, share * kGrey);
    light.ambientColor = glm::mix(light.ambientColor, glm::vec3(level), share * kGrey * 0.5F);
    light.ambientStrength *= 1.0F + 0.9F * share;
    light.sunStrength *= 1.0F - 0.75F * share;
    light.shadowSoftnessRadians *= 1.0F + 6.0F * share;
    light.shadowStrength *= 1.0F - 0.3F * share;
}

} // namespace

bool isDark(const Lighting& lighting)
{
    constexpr float kLampsGoOn = 0.45F; // overcast is twice as bright, dusk a third darker
    const glm::vec3 eye(0.2126F, 0.7152F, 0.0722F);
    const float sun = glm::dot(lighting.sunColor, eye) * lighting.sunStrength *
                      std::max(std::sin(lighting.sunElevationRadians), 0.0F);
    return sun + glm::dot(lighting.ambientColor, eye) * lighting.ambientStrength < kLampsGoOn;
}

void setDayHours(Lighting& lighting, float hours)
{
    const float turned = (wrapped(hours, kHoursADay) / kHoursADay - 0.5F) * kTurn;
    const glm::vec2 sun = placeOf(turned);
    const SkyAt sky = skyAt(sun.y / kDegree);
    const bool isMoon = sky.elevationDegrees < kMoonDegrees;
    const glm::vec2 moon = placeOf(turned > 0.0F ? turned - kTurn / 2.0F : turned + kTurn / 2.0F);
    lighting.sunAzimuthRadians = isMoon ? moon.x : sun.x;
    lighting.sunElevationRadians =
        isMoon ? std::max(moon.y, kLowestMoon) : std::max(sun.y, kLowestSun);
    lighting.sunColor =
        isMoon ? kSkies.front().sun : skyAt(std::max(sky.elevationDegrees, kAfterglowDegrees)).sun;
    lighting.sunStrength = sky.sunStrength;
    lighting.ambientColor = sky.light;
    lighting.ambientStrength = sky.lightStrength;
    lighting.skyZenith = sky.zenith;
    lighting.skyHorizon = sky.horizon;
    lighting.shadowStrength = 0.85F;
    lighting.shadowSoftnessRadians = 1.2F * kDegree;
    addHaze(lighting);
}

float dayHours(const Lighting& lighting)
{
    const float azimuth = wrapped(lighting.sunAzimuthRadians + kTurn / 2.0F, kTurn) - kTurn / 2.0F;
    const bool isMoon = lighting.sunColor.z > lighting.sunColor.x &&
                        std::max({lighting.skyHorizon.x, lighting.skyHorizon.y,
                                  lighting.skyHorizon.z}) < kDarkHorizon;
    const float byAzimuth = turnedAt(azimuth);
    if (isMoon) {
        return wrapped(byAzimuth / kTurn * kHoursADay, kHoursADay);
    }
    // By day its height says it, wherever it was turned to; at the horizon all hours are one.
    const bool isHigh = lighting.sunElevationRadians > kLowestSun * 1.01F;
    const float turned =
        isHigh ? std::copysign(turnedTo(lighting.sunElevationRadians), byAzimuth) : byAzimuth;
    return wrapped((turned / kTurn + 0.5F) * kHoursADay, kHoursADay);
}

void followHaze(Lighting& lighting, const Lighting& before)
{
    constexpr float kAlike = 0.02F;
    if (lighting.haze == before.haze) {
        return;
    }
    const float hours = dayHours(before);
    Lighting made = before;
    setDayHours(made, hours);
    const auto isAlike = [](const glm::vec3& a, const glm::vec3& b) {
        return glm::length(a - b) < kAlike;
    };
    const bool isAsMade = isAlike(made.sunColor, before.sunColor) &&
                          isAlike(made.ambientColor, before.ambientColor) &&
                          isAlike(made.skyZenith, before.skyZenith) &&
                          isAlike(made.skyHorizon, before.skyHorizon) &&
                          std::abs(made.sunStrength - before.sunStrength) < kAlike &&
                          std::abs(made.ambientStrength - before.ambientStrength) < kAlike;
    if (!isAsMade) {
        return;
    }
    const float azimuth = lighting.sunAzimuthRadians; // it may have been turned
    const float elevation = lighting.sunElevationRadians;
    setDayHours(lighting, hours);
    lighting.sunAzimuthRadians = azimuth;
    lighting.sunElevationRadians = elevation;
}

} // namespace crowd::model
