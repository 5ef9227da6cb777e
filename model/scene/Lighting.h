// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <tuple>

#include <glm/vec3.hpp>

#include "model/describe/Field.h"

namespace crowd::model {

/// What brightness beyond white becomes.
enum class ToneMap : std::uint8_t {
    None,  ///< white
    Filmic ///< it rolls off as on film
};

inline constexpr std::array kToneMaps{FieldChoice{"none", QT_TRANSLATE_NOOP("Fields", "As it is")},
                                      FieldChoice{"filmic", QT_TRANSLATE_NOOP("Fields", "Filmic")}};

/// The light that is everywhere: a sun, the sky, and the ground that throws light back. Colours
/// sRGB 0..1.
struct Lighting
{
    float sunAzimuthRadians = 0.6F; ///< from +Z towards +X, where the sun stands
    float sunElevationRadians = 0.9F;
    glm::vec3 sunColor{1.0F, 0.96F, 0.88F};
    float sunStrength = 1.0F;
    float shadowStrength = 0.0F;         ///< of what the sun casts; 0: none is cast
    float shadowSoftnessRadians = 0.02F; ///< angle that the sun takes in the sky
    float highlights = 0.0F; ///< of what smooth surfaces mirror: sun, lamps and sky; 0: none
    glm::vec3 ambientColor{0.62F, 0.70F, 0.82F};
    float ambientStrength = 0.6F;
    float occlusion = 0.0F; ///< how dark it is where the sky is hidden by what is near; 0: not
    glm::vec3 skyZenith{0.35F, 0.53F, 0.78F};
    glm::vec3 skyHorizon{0.80F, 0.87F, 0.93F};
    glm::vec3 ground{0.58F, 0.57F, 0.53F};
    bool showGroundGrid = true;
    float haze = 0.0F;          ///< share of what is a hundred metres away that the air hides
    float hazeHeight = 0.0F;    ///< metres above 0 where a third of it is left; 0: everywhere alike
    float exposureStops = 0.0F; ///< each doubles the brightness
    float whiteKelvin = 6500.0F; ///< the light that looks white
    ToneMap toneMap = ToneMap::None;
    std::string unknownMembers; ///< see Scene::unknownMembers

    static constexpr auto fields();
    friend bool operator==(const Lighting&, const Lighting&) = default;
};

/// As a new scene is lit, with shadows; what files and scripts leave out is as Lighting begins.
[[nodiscard]] Lighting newLighting();

// See DayLight.h.
void setDayHours(Lighting& lighting, float hours);
[[nodiscard]] float dayHours(const Lighting& lighting);

constexpr auto Lighting::fields()
{
    using S = Lighting;
    using C = FieldContext;
    constexpr double kMostTurned = 1e6; // radians
    constexpr double kBrightest = 1000.0;
    constexpr double kDegrees = 57.29577951308232;
    return std::tuple(
        computed<S, float>(
            &dayHours, &setDayHours,
            {.key = "dayHours",
             .label = QT_TRANSLATE_NOOP("Fields", "Time of Day"),
             .tip = QT_TRANSLATE_NOOP("Fields", "Puts sun or moon, sky and their colours as they "
                                                "are at that hour, paler and softer where there is "
                                                "haze; everything can be changed afterwards"),
             .unit = QT_TRANSLATE_NOOP("Fields", " h"),
             .high = 24.0,
             .sliderLow = 0.0,
             .sliderHigh = 23.9,
             .step = 0.1,
             .decimals = 1,
             .section = QT_TRANSLATE_NOOP("Fields", "Sun")}),
        field(&S::sunAzimuthRadians, {.key = "sunAzimuth",
                                      .label = QT_TRANSLATE_NOOP("Fields", "Direction"),
                                      .tip = QT_TRANSLATE_NOOP("Fields", "Where the sun stands"),
                                      .doc = "where the sun stands, from +Z towards +X",
                                      .unit = QT_TRANSLATE_NOOP("Fields", "°"),
                                      .low = -kMostTurned,
                                      .high = kMostTurned,
                                      .sliderLow = -180.0,
                                      .sliderHigh = 180.0,
                                      .step = 1.0,
                                      .decimals = 0,
                                      .shownScale = kDegrees,
                                      .role = FieldRole::Angle}),
        field(&S::sunElevationRadians,
              {.key = "sunElevation",
               .label = QT_TRANSLATE_NOOP("Fields", "Height"),
               .tip = QT_TRANSLATE_NOOP("Fields", "How high the sun stands over the horizon"),
               .doc = "how high it stands over the horizon",
               .unit = QT_TRANSLATE_NOOP("Fields", "°"),
               .low = -kMostTurned,
               .high = kMostTurned,
               .sliderLow = 0.0,
               .sliderHigh = 90.0,
               .step = 1.0,
               .decimals = 0,
               .shownScale = kDegrees,
               .role = FieldRole::Angle}),
        field(&S::sunColor, {.key = "sunColor",
                             .label = QT_TRANSLATE_NOOP("Fields", "Colour"),
                             .doc = "of the sun",
                             .role = FieldRole::Color}),
        field(&S::sunStrength, {.key = "sunStrength",
                                .label = QT_TRANSLATE_NOOP("Fields", "Strength"),
                                .doc = "of the sun; 1: as on a clear day",
                                .unit = QT_TRANSLATE_NOOP("Fields", " %"),
                                .high = kBrightest,
                                .sliderLow = 0.0,
                                .sliderHigh = 300.0,
                                .step = 5.0,
                                .decimals = 0,
                                .shownScale = 100.0}),
        field(&S::shadowStrength,
              {.key = "shadowStrength",
               .label = QT_TRANSLATE_NOOP("Fields", "Shadows"),
               .tip = QT_TRANSLATE_NOOP("Fields", "How dark the shadows are that people and stages "
                                                  "cast; 0: none"),
               .doc = "how dark the shadows are that people and stages cast; 0: none are cast",
               .unit = QT_TRANSLATE_NOOP("Fields", " %"),
               .step = 5.0,
               .decimals = 0,
               .shownScale = 100.0}),
        field(
            &S::shadowSoftnessRadians,
            {.key = "shadowSoftness",
             .label = QT_TRANSLATE_NOOP("Fields", "Softness"),
             .tip = QT_TRANSLATE_NOOP("Fields", "How large the sun is in the sky: the larger, the "
                                                "softer the edges of shadows"),
             .doc = "the angle that the sun takes in the sky: the larger, the softer its shadows",
             .unit = QT_TRANSLATE_NOOP("Fields", "°"),
             .high = 0.5,
             .sliderLow = 0.0,
             .sliderHigh = 10.0,
             .step = 0.1,
             .decimals = 1,
             .shownScale = kDegrees})
            .when([](const S& s, const C&) { return s.shadowStrength > 0.0F; }),
        field(&S::highlights,
              {.key = "highlights",
               .label = QT_TRANSLATE_NOOP("Fields", "Highlights"),
               .tip = QT_TRANSLATE_NOOP("Fields", "How strongly what is smooth, as water, glass, "
                                                  "metal and skin, mirrors the sun, the lamps and "
                                                  "the sky; 0: not"),
               .doc = "how strongly smooth surfaces mirror the sun, the lamps and the sky; 0: not",
               .unit = QT_TRANSLATE_NOOP("Fields", " %"),
               .high = 4.0,
               .sliderLow = 0.0,
               .sliderHigh = 200.0,
               .step = 5.0,
               .decimals = 0,
               .shownScale = 100.0}),
        field(&S::ambientColor, {.key = "ambientColor",
                                 .label = QT_TRANSLATE_NOOP("Fields", "Light"),
                                 .tip = QT_TRANSLATE_NOOP("Fields", "The colour of the light that "
                                                                    "comes from all of the sky"),
                                 .doc = "of the light that comes from all of the sky",
                                 .role = FieldRole::Color,
                                 .section = QT_TRANSLATE_NOOP("Fields", "Sky")}),
        field(&S::ambientStrength, {.key = "ambientStrength",
                                    .label = QT_TRANSLATE_NOOP("Fields", "Strength"),
                                    .doc = "of the sky's light",
                                    .unit = QT_TRANSLATE_NOOP("Fields", " %"),
                                    .high = kBrightest,
                                    .sliderLow = 0.0,
                                    .sliderHigh = 300.0,
                                    .step = 5.0,
                                    .decimals = 0,
                                    .shownScale = 100.0}),
        field(
            &S::occlusion,
            {.key = "occlusion",
             .label = QT_TRANSLATE_NOOP("Fields", "Occlusion"),
             .tip = QT_TRANSLATE_NOOP("Fields", "How dark it is in corners, under people and where "
                                                "they sit: less of the sky is seen from there"),
             .doc = "how dark it is in corners and where bodies meet ground and seats; 0: not",
             .unit = QT_TRANSLATE_NOOP("Fields", " %"),
             .step = 5.0,
             .decimals = 0,
             .shownScale = 100.0}),
        field(&S::skyZenith, {.key = "skyZenith",
                              .label = QT_TRANSLATE_NOOP("Fields", "Above"),
                              .tip = QT_TRANSLATE_NOOP("Fields", "The sky overhead"),
                              .doc = "the sky overhead",
                              .role = FieldRole::Color}),
        field(&S::skyHorizon, {.key = "skyHorizon",
                               .label = QT_TRANSLATE_NOOP("Fields", "Horizon"),
                               .tip = QT_TRANSLATE_NOOP("Fields", "The sky at the horizon, and the "
                                                                  "ground far away"),
                               .doc = "the sky at the horizon, and the ground far away",
                               .role = FieldRole::Color}),
        field(&S::ground, {.key = "ground",
                           .label = QT_TRANSLATE_NOOP("Fields", "Colour"),
                           .doc = "of the ground",
                           .role = FieldRole::Color,
                           .section = QT_TRANSLATE_NOOP("Fields", "Ground")}),
        field(&S::showGroundGrid, {.key = "groundGrid",
                                   .label = QT_TRANSLATE_NOOP("Fields", "Grid"),
                                   .tip = QT_TRANSLATE_NOOP("Fields", "Lines a metre apart"),
                                   .doc = "lines a metre apart"}),
        field(&S::haze, {.key = "haze",
                         .label = QT_TRANSLATE_NOOP("Fields", "Haze"),
                         .tip = QT_TRANSLATE_NOOP("Fields", "How much of what is a hundred metres "
                                                            "away the air hides"),
                         .doc = "share of what is a hundred metres away that the air hides",
                         .unit = QT_TRANSLATE_NOOP("Fields", " %"),
                         .high = 0.999,
                         .sliderLow = 0.0,
                         .sliderHigh = 99.0,
                         .step = 5.0,
                         .decimals = 0,
                         .shownScale = 100.0,
                         .section = QT_TRANSLATE_NOOP("Fields", "Air and Exposure")}),
        field(&S::hazeHeight,
              {.key = "hazeHeight",
               .label = QT_TRANSLATE_NOOP("Fields", "Lies low, up to"),
               .tip = QT_TRANSLATE_NOOP("Fields", "The height above the ground at which a third of "
                                                  "it is left, as of mist over a square; 0: it is "
                                                  "everywhere alike"),
               .doc = "metres above 0 where a third of it is left, as of mist; 0: it is everywhere "
                      "alike",
               .unit = QT_TRANSLATE_NOOP("Fields", " m"),
               .high = 10000.0,
               .sliderLow = 0.0,
               .sliderHigh = 20.0,
               .step = 0.5,
               .decimals = 1})
            .when([](const S& s, const C&) { return s.haze > 0.0F; }),
        field(&S::exposureStops,
              {.key = "exposure",
               .label = QT_TRANSLATE_NOOP("Fields", "Exposure"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Each stop doubles the brightness"),
               .doc = "stops: each doubles the brightness",
               .low = -10.0,
               .high = 10.0,
               .sliderLow = -4.0,
               .sliderHigh = 4.0,
               .step = 0.1,
               .decimals = 1}),
        field(
            &S::whiteKelvin,
            {.key = "white",
             .label = QT_TRANSLATE_NOOP("Fields", "White"),
             .tip = QT_TRANSLATE_NOOP("Fields", "The colour of light that looks white: lower makes "
                                                "the picture bluer, higher warmer"),
             .doc = "the light that looks white, kelvin: lower makes the picture bluer",
             .unit = QT_TRANSLATE_NOOP("Fields", " K"),
             .low = 1500.0,
             .high = 20000.0,
             .sliderLow = 2500.0,
             .sliderHigh = 12000.0,
             .step = 100.0,
             .decimals = 0}),
        field(&S::toneMap,
              {.key = "tone",
               .label = QT_TRANSLATE_NOOP("Fields", "Tone"),
               .tip = QT_TRANSLATE_NOOP("Fields", "What is brighter than white"),
               .doc = "what brightness beyond white becomes: white, or it rolls off as on film",
               .choices = kToneMaps}));
}

} // namespace crowd::model
