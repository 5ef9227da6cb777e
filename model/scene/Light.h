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
#include "model/scene/Group.h"

/// Lights that stand in the scene, beside the sun and the sky of its Lighting. Plain values, part
/// of the scene. World frame, metres; colours sRGB.
namespace crowd::model {

/// A stable name within a scene; 0: none.
using LightId = std::uint32_t;

enum class LightKind : std::uint8_t {
    Spot, ///< a cone
    Point ///< to all sides
};

/// What a spotlight turns to.
enum class LightAim : std::uint8_t { Place, Person, Group };

inline constexpr std::size_t kMostLights = 1000;
/// So many are drawn: the strongest of those that are on.
inline constexpr std::size_t kMostLightsDrawn = 16;
/// So many of these cast shadows: the strongest of those that are to.
inline constexpr std::size_t kMostLightShadows = 4;
/// Where a light of strength 1 is as bright as a sun of strength 1; nearer it is brighter by the
/// square of the distance.
inline constexpr float kLightMetres = 10.0F;

struct Light
{
    LightId id = 0;
    std::string name;
    bool isOn = true;
    LightKind kind = LightKind::Spot;
    PaintColor color{255, 244, 224};
    float strength = 1.0F;
    glm::vec3 position{0.0F, 8.0F, 8.0F}; ///< of the lamp
    LightAim aim = LightAim::Place;
    glm::vec3 target{0.0F};       ///< Place: the middle of what it lights
    IndividualId person = 0;      ///< Person: it goes with him
    GroupId group = 0;            ///< Group: the middle of those in it
    float coneRadians = 0.44F;    ///< from edge to edge
    float softness = 0.3F;        ///< share of the cone in which it fades out
    float beam = 0.15F;           ///< how much of it is seen in the air
    bool castsShadows = false;    ///< people and stages stand in its light
    std::string unknownMembers{}; ///< see Scene::unknownMembers

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

inline constexpr std::array kLightKinds{
    FieldChoice{"spot", QT_TRANSLATE_NOOP("Fields", "Spotlight")},
    FieldChoice{"point", QT_TRANSLATE_NOOP("Fields", "Point light")}};
inline constexpr std::array kLightAims{
    FieldChoice{"place", QT_TRANSLATE_NOOP("Fields", "a place")},
    FieldChoice{"person", QT_TRANSLATE_NOOP("Fields", "somebody"),
                QT_TRANSLATE_NOOP("Fields", "It goes with him while it plays. Select somebody and "
                                            "press the button.")},
    FieldChoice{"group", QT_TRANSLATE_NOOP("Fields", "a group"),
                QT_TRANSLATE_NOOP("Fields", "It goes with the middle of those in it.")}};

constexpr auto Light::fields()
{
    using S = Light;
    using C = FieldContext;
    constexpr double kFurthest = 1e6; // metres
    constexpr double kDegrees = 57.29577951308232;
    constexpr auto hasCone = [](const S& s, const C&) { return isAimed(s); };
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
        field(&S::coneRadians, {.key = "cone",
                                .label = QT_TRANSLATE_NOOP("Fields", "Cone"),
                                .tip = QT_TRANSLATE_NOOP("Fields", "How wide it opens"),
                                .doc = "how wide it opens, from edge to edge",
                                .unit = QT_TRANSLATE_NOOP("Fields", "°"),
                                .low = 0.01,
                                .high = 3.0,
                                .sliderLow = 1.0,
                                .sliderHigh = 120.0,
                                .step = 1.0,
                                .decimals = 0,
                                .shownScale = kDegrees,
                                .role = FieldRole::Opening})
            .when(hasCone),
        field(&S::softness, {.key = "softness",
                             .label = QT_TRANSLATE_NOOP("Fields", "Soft Edge"),
                             .doc = "share of the cone in which it fades out; 0: a sharp edge",
                             .unit = QT_TRANSLATE_NOOP("Fields", " %"),
                             .step = 5.0,
                             .decimals = 0,
                             .shownScale = 100.0})
            .when(hasCone),
        field(&S::beam, {.key = "beam",
                         .label = QT_TRANSLATE_NOOP("Fields", "Beam"),
                         .tip = QT_TRANSLATE_NOOP("Fields", "How much of it is seen in the air, as "
                                                            "in smoke"),
                         .doc = "how much of it is seen in the air, as in smoke",
                         .unit = QT_TRANSLATE_NOOP("Fields", " %"),
                         .step = 5.0,
                         .decimals = 0,
                         .shownScale = 100.0})
            .when(hasCone),
        field(&S::castsShadows,
              {.key = "shadows",
               .label = QT_TRANSLATE_NOOP("Fields", "Shadows"),
               .tip = QT_TRANSLATE_NOOP("Fields", "People and stages stand in its light. The four "
                                                  "strongest lights that are to cast shadows do."),
               .doc = "people and stages cast shadows in its light; of those that are to, the four "
                      "strongest do"}),
        field(&S::aim, {.key = "aim",
                        .label = QT_TRANSLATE_NOOP("Fields", "Aims at"),
                        .doc = "what it turns to",
                        .choices = kLightAims})
            .when(hasCone),
        field(&S::target, {.key = "target",
                           .label = QT_TRANSLATE_NOOP("Fields", "Target"),
                           .doc = "the middle of what it lights, of \"place\"",
                           .unit = QT_TRANSLATE_NOOP("Fields", " m"),
                           .low = -kFurthest,
                           .high = kFurthest,
                           .sliderLow = -50.0,
                           .sliderHigh = 50.0,
                           .step = 0.1,
                           .decimals = 1,
                           .role = FieldRole::Target})
            .when([](const S& s, const C&) { return isAimed(s) && s.aim == LightAim::Place; }),
        field(&S::person, {.key = "person",
                           .label = QT_TRANSLATE_NOOP("Fields", "Person"),
                           .doc = "whom it goes with, of \"person\": an id; 0: nobody",
                           .high = 4294967295.0,
                           .role = FieldRole::Individual})
            .when([](const S& s, const C&) { return isAimed(s) && s.aim == LightAim::Person; }),
        field(&S::group, {.key = "group",
                          .label = QT_TRANSLATE_NOOP("Fields", "Group"),
                          .doc = "of \"group\"; 0: none",
                          .high = 4294967295.0,
                          .role = FieldRole::Group,
                          .zero = QT_TRANSLATE_NOOP("Fields", "choose…")})
            .when([](const S& s, const C&) { return isAimed(s) && s.aim == LightAim::Group; }),
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
