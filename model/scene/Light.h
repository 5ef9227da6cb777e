// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include <glm/vec3.hpp>

#include "model/base/Values.h"
#include "model/describe/Field.h"
#include "model/scene/lights/PointLight.h"
#include "model/scene/lights/SpotLight.h"

/// Lights that stand in the scene, beside the sun and the sky of its Lighting. Plain values, part
/// of the scene. World frame, metres; colours sRGB.
namespace crowd::model {

/// A stable name within a scene; 0: none.
using LightId = std::uint32_t;

/// Which of the files of lights/ it is. A light keeps what it has of the others.
enum class LightKind : std::uint8_t {
    Spot, ///< a cone
    Point ///< to all sides
};

inline constexpr std::size_t kMostLights = 1000;
/// So many are drawn: the strongest of those that are on.
inline constexpr std::size_t kMostLightsDrawn = 16;
/// So many of these cast shadows: the strongest of those that are to.
inline constexpr std::size_t kMostLightShadows = 4;
/// Where a light of strength 1 is as bright as a sun of strength 1; nearer it is brighter by the
/// square of the distance.
inline constexpr float kLightMetres = 10.0F;

struct Light : SpotSettings
{
    LightId id = 0;
    std::string name;
    bool isOn = true;
    LightKind kind = LightKind::Spot;
    PaintColor color{255, 244, 224};
    float strength = 1.0F;
    float sizeMetres = 0.5F;              ///< of the lamp: what is nearer gets no brighter
    glm::vec3 position{0.0F, 8.0F, 8.0F}; ///< of the lamp
    bool isOnlyAfterDark = false;         ///< see isDark(): it does not shine by day
    bool castsShadows = false;            ///< people and stages stand in its light
    std::string unknownMembers{};         ///< see Scene::unknownMembers

    static constexpr auto fields();
    friend bool operator==(const Light&, const Light&) = default;
};

using Lights = std::vector<Light>;

/// Whether it is turned to something, rather than shining to all sides.
[[nodiscard]] inline bool isAimed(const Light& light)
{
    return light.kind == LightKind::Spot;
}
/// One that lights a point, as it is seen from another one; without name and id.
[[nodiscard]] Light newLight(LightKind kind, const glm::vec3& lit, const glm::vec3& seenFrom);

[[nodiscard]] const Light* findLight(const Lights& lights, LightId id); ///< null: there is none
/// The next one's, which is above `taken`; 0: there are as many as there can be.
[[nodiscard]] LightId freeLightId(const Lights& lights, LightId taken = 0);

inline constexpr std::array kLightKinds{kSpotLight, kPointLight};

constexpr auto Light::fields()
{
    using S = Light;
    using C = FieldContext;
    constexpr double kFurthest = 1e6; // metres
    return std::tuple(
        field(&S::id, {.key = "id",
                       .doc = "of no other light of the scene",
                       .low = 1.0,
                       .high = 4294967295.0}),
        field(&S::name, {.key = "name", .doc = "what it is called"}),
        field(&S::isOn, {.key = "on", .doc = "it shines"}),
        field(&S::kind, {.key = "kind",
                         .label = QT_TRANSLATE_NOOP("Fields", "Kind"),
                         .doc = "a cone, or light to all sides",
                         .choices = kLightKinds}),
        field(&S::strength,
              {.key = "strength",
               .label = QT_TRANSLATE_NOOP("Fields", "Strength"),
               .tip = QT_TRANSLATE_NOOP("Fields", "At 100 % it is as bright as the sun ten metres "
                                                  "away; nearer it is brighter"),
               .doc = "1: as bright as the sun at ten metres; it falls off with the square of the "
                      "distance",
               .unit = QT_TRANSLATE_NOOP("Fields", " %"),
               .high = 1000.0,
               .sliderLow = 0.0,
               .sliderHigh = 500.0,
               .step = 5.0,
               .decimals = 0,
               .shownScale = 100.0}),
        field(&S::color, {.key = "color",
                          .label = QT_TRANSLATE_NOOP("Fields", "Colour"),
                          .doc = "of its light"}),
        field(
            &S::sizeMetres,
            {.key = "size",
             .label = QT_TRANSLATE_NOOP("Fields", "Size"),
             .tip = QT_TRANSLATE_NOOP("Fields", "Of the lamp: what is nearer to it than that gets "
                                                "no brighter"),
             .doc = "of the lamp: what is nearer to it than that gets no brighter",
             .unit = QT_TRANSLATE_NOOP("Fields", " m"),
             .low = 0.01,
             .high = 1000.0,
             .sliderLow = 0.1,
             .sliderHigh = 10.0,
             .step = 0.1,
             .decimals = 1}),
        field(
            &S::isOnlyAfterDark,
            {.key = "afterDark",
             .label = QT_TRANSLATE_NOOP("Fields", "Only After Dark"),
             .tip = QT_TRANSLATE_NOOP("Fields", "As street lamps: it shines while sun and sky are "
                                                "dark"),
             .doc = "it shines only while sun and sky are dark, as street lamps"}),
        field(&S::castsShadows,
              {.key = "shadows",
               .label = QT_TRANSLATE_NOOP("Fields", "Shadows"),
               .tip = QT_TRANSLATE_NOOP("Fields", "People and stages stand in its light. The four "
                                                  "strongest lights that are to cast shadows do."),
               .doc = "people and stages cast shadows in its light; of those that are to, the four "
                      "strongest do"}),
        inherited<S, SpotSettings>([](const S& s, const C&) { return isAimed(s); }),
        field(&S::position, {.key = "position",
                             .label = QT_TRANSLATE_NOOP("Fields", "Lamp"),
                             .tip = QT_TRANSLATE_NOOP("Fields", "Where it hangs or stands"),
                             .doc = "where the lamp is",
                             .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                             .low = -kFurthest,
                             .high = kFurthest,
                             .sliderLow = -50.0,
                             .sliderHigh = 50.0,
                             .step = 0.1,
                             .decimals = 1,
                             .role = FieldRole::Space}));
}

} // namespace crowd::model
