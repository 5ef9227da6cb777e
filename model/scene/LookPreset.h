// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "model/base/Values.h"
#include "model/describe/Field.h"
#include "model/scene/Lighting.h"

/// Looks that belong to a scene: a way of drawing with a light and a background of its own, under a
/// name. Plain values, part of the scene. Colours sRGB.
namespace crowd::model {

/// A stable name within a scene; 0: none.
using LookId = std::uint32_t;

/// How surfaces are drawn. Saved by the keys of kLookStyles.
enum class LookStyle : std::uint8_t {
    Plain,
    Lit,
    Cartoon,
    Clay,
    Silhouettes,
    Blueprint,
    Wireframe,
    Property
};

/// Whose sun and sky there are.
enum class LookLight : std::uint8_t { Scene, Noon, Afternoon, Dusk, Overcast, Night, Studio, Own };

inline constexpr std::size_t kMostLooks = 1000;

struct LookPreset
{
    LookId id = 0;
    std::string name;
    LookStyle style = LookStyle::Lit;
    std::string property = "template"; ///< what people are coloured by, of Property
    bool isTwoTone = false; ///< of Cartoon: light and shade alone, without a step between
    LookLight light = LookLight::Scene;
    Lighting ownLight;      ///< of Own
    bool hasLamps = true;   ///< the lights that stand in the scene shine
    bool hasShadows = true; ///< of any kind
    bool hasBackground = false;
    PaintColor background{236, 238, 240}; ///< instead of the sky
    bool hasGround = true;                ///< the ground plane is drawn
    bool hasOutline = false;              ///< instead of the style's own
    PaintColor outline{20, 18, 24};
    float outlinePixels = 2.0F;   ///< logical; 0: no outlines, whatever the style has
    std::string unknownMembers{}; ///< see Scene::unknownMembers

    static constexpr auto fields();
    friend bool operator==(const LookPreset&, const LookPreset&) = default;
};

using Looks = std::vector<LookPreset>;

[[nodiscard]] const LookPreset* findLook(const Looks& looks, LookId id); ///< null: there is none
[[nodiscard]] const LookPreset* findLook(const Looks& looks, const std::string& name);
/// Sun and sky in that look of a scene that is lit so.
[[nodiscard]] Lighting lightIn(const LookPreset& look, const Lighting& scenes);

inline constexpr std::array kLookStyles{
    FieldChoice{"plain", QT_TRANSLATE_NOOP("Fields", "Plain colours")},
    FieldChoice{"lit", QT_TRANSLATE_NOOP("Fields", "Lit")},
    FieldChoice{"cartoon", QT_TRANSLATE_NOOP("Fields", "Cartoon")},
    FieldChoice{"clay", QT_TRANSLATE_NOOP("Fields", "Clay")},
    FieldChoice{"silhouettes", QT_TRANSLATE_NOOP("Fields", "Silhouettes")},
    FieldChoice{"blueprint", QT_TRANSLATE_NOOP("Fields", "Blueprint")},
    FieldChoice{"wireframe", QT_TRANSLATE_NOOP("Fields", "Wireframe")},
    FieldChoice{"property", QT_TRANSLATE_NOOP("Fields", "By property")}};
inline constexpr std::array kLookLights{
    FieldChoice{"scene", QT_TRANSLATE_NOOP("Fields", "The scene's")},
    FieldChoice{"noon", QT_TRANSLATE_NOOP("Fields", "Noon")},
    FieldChoice{"afternoon", QT_TRANSLATE_NOOP("Fields", "Afternoon")},
    FieldChoice{"dusk", QT_TRANSLATE_NOOP("Fields", "Dusk")},
    FieldChoice{"overcast", QT_TRANSLATE_NOOP("Fields", "Overcast")},
    FieldChoice{"night", QT_TRANSLATE_NOOP("Fields", "Night")},
    FieldChoice{"studio", QT_TRANSLATE_NOOP("Fields", "Studio")},
    FieldChoice{"own", QT_TRANSLATE_NOOP("Fields", "Its own"),
                QT_TRANSLATE_NOOP("Fields", "Begins as what is seen, and can be set below")}};

constexpr auto LookPreset::fields()
{
    using S = LookPreset;
    using C = FieldContext;
    return std::tuple(
        field(&S::id, {.key = "id",
                       .doc = "of no other look of the scene",
                       .low = 1.0,
                       .high = 4294967295.0}),
        field(&S::name, {.key = "name", .doc = "what it is called"}),
        field(&S::style, {.key = "style",
                          .label = QT_TRANSLATE_NOOP("Fields", "Style"),
                          .tip = QT_TRANSLATE_NOOP("Fields", "How surfaces are drawn"),
                          .doc = "how surfaces are drawn",
                          .choices = kLookStyles}),
        field(&S::property, {.key = "by",
                             .label = QT_TRANSLATE_NOOP("Fields", "By"),
                             .doc = "what people are coloured by, of \"property\""})
            .when([](const S& s, const C&) { return s.style == LookStyle::Property; }),
        field(&S::isTwoTone,
              {.key = "twoTones",
               .label = QT_TRANSLATE_NOOP("Fields", "Two Tones"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Light and shade alone, without a step between"),
               .doc = "of \"cartoon\": light and shade alone, without a step between"})
            .when([](const S& s, const C&) { return s.style == LookStyle::Cartoon; }),
        field(&S::light, {.key = "light",
                          .label = QT_TRANSLATE_NOOP("Fields", "Light"),
                          .tip = QT_TRANSLATE_NOOP("Fields", "Sun and sky: those of the scene, "
                                                             "ready-made ones, or its own"),
                          .doc = "sun and sky: those of the scene, ready-made ones, or its own",
                          .choices = kLookLights}),
        field(&S::hasLamps,
              {.key = "lamps",
               .label = QT_TRANSLATE_NOOP("Fields", "Spotlights"),
               .tip = QT_TRANSLATE_NOOP("Fields", "The lights that stand in the scene shine"),
               .doc = "the lights that stand in the scene shine"}),
        field(&S::hasShadows, {.key = "shadows",
                               .label = QT_TRANSLATE_NOOP("Fields", "Shadows"),
                               .doc = "shadows are drawn, of any kind"}),
        field(&S::hasBackground,
              {.key = "ownBackground",
               .label = QT_TRANSLATE_NOOP("Fields", "Background"),
               .tip = QT_TRANSLATE_NOOP("Fields", "One colour instead of the sky"),
               .doc = "one colour instead of the sky"}),
        field(&S::background, {.key = "background",
                               .label = QT_TRANSLATE_NOOP("Fields", "Colour"),
                               .doc = "instead of the sky"})
            .when([](const S& s, const C&) { return s.hasBackground; }),
        field(&S::hasGround,
              {.key = "ground",
               .label = QT_TRANSLATE_NOOP("Fields", "Ground"),
               .tip = QT_TRANSLATE_NOOP("Fields", "The ground around stages is drawn"),
               .doc = "the ground around stages is drawn"}),
        field(&S::hasOutline,
              {.key = "ownOutline",
               .label = QT_TRANSLATE_NOOP("Fields", "Own Outlines"),
               .tip = QT_TRANSLATE_NOOP("Fields", "Lines around things, instead of those that the "
                                                  "style has"),
               .doc = "outlines are as the next two say, not as the style has them"}),
        field(&S::outlinePixels, {.key = "outlineWidth",
                                  .label = QT_TRANSLATE_NOOP("Fields", "Width"),
                                  .doc = "of outlines; 0: none",
                                  .unit = QT_TRANSLATE_NOOP("Fields", " px"),
                                  .high = 20.0,
                                  .sliderLow = 0.0,
                                  .sliderHigh = 6.0,
                                  .step = 0.5,
                                  .decimals = 1})
            .when([](const S& s, const C&) { return s.hasOutline; }),
        field(&S::outline, {.key = "outline",
                            .label = QT_TRANSLATE_NOOP("Fields", "Colour"),
                            .doc = "of outlines"})
            .when([](const S& s, const C&) { return s.hasOutline; }),
        field(&S::ownLight, {.key = "ownLight", .doc = "of \"own\": sun and sky", .isBrief = true})
            .when([](const S& s, const C&) { return s.light == LookLight::Own; }));
}

} // namespace crowd::model
