// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include <glm/vec3.hpp>

#include "model/base/Values.h"
#include "model/describe/Field.h"
#include "model/scene/Group.h"

namespace crowd::model {

struct Light;

/// What a spotlight turns to.
enum class LightAim : std::uint8_t { Place, Person, Group };

/// What a cone of light has that other lights have not. World frame, metres.
struct SpotSettings
{
    LightAim aim = LightAim::Place;
    glm::vec3 target{0.0F};    ///< Place: the middle of what it lights
    IndividualId person = 0;   ///< Person: it goes with him
    GroupId group = 0;         ///< Group: the middle of those in it
    float coneRadians = 0.44F; ///< from edge to edge
    float softness = 0.3F;     ///< share of the cone in which it fades out
    float beam = 0.15F;        ///< how much of it is seen in the air

    static constexpr auto fields();
    friend bool operator==(const SpotSettings&, const SpotSettings&) = default;
};

inline constexpr FieldChoice kSpotLight{"spot", QT_TRANSLATE_NOOP("Fields", "Spotlight")};
/// It hangs above, to one side of whoever looks.
void beginSpot(Light& light, const glm::vec3& lit, const glm::vec3& seenFrom);

inline constexpr std::array kLightAims{
    FieldChoice{"place", QT_TRANSLATE_NOOP("Fields", "a place")},
    FieldChoice{"person", QT_TRANSLATE_NOOP("Fields", "somebody"),
                QT_TRANSLATE_NOOP("Fields", "It goes with him while it plays. Select somebody and "
                                            "press the button.")},
    FieldChoice{"group", QT_TRANSLATE_NOOP("Fields", "a group"),
                QT_TRANSLATE_NOOP("Fields", "It goes with the middle of those in it.")}};

constexpr auto SpotSettings::fields()
{
    using S = SpotSettings;
    using C = FieldContext;
    constexpr double kFurthest = 1e6; // metres
    constexpr double kDegrees = 57.29577951308232;
    return std::tuple(
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
                                .role = FieldRole::Opening}),
        field(&S::softness, {.key = "softness",
                             .label = QT_TRANSLATE_NOOP("Fields", "Soft Edge"),
                             .doc = "share of the cone in which it fades out; 0: a sharp edge",
                             .unit = QT_TRANSLATE_NOOP("Fields", " %"),
                             .step = 5.0,
                             .decimals = 0,
                             .shownScale = 100.0}),
        field(&S::beam, {.key = "beam",
                         .label = QT_TRANSLATE_NOOP("Fields", "Beam"),
                         .tip = QT_TRANSLATE_NOOP("Fields", "How much of it is seen in the air, as "
                                                            "in smoke"),
                         .doc = "how much of it is seen in the air, as in smoke",
                         .unit = QT_TRANSLATE_NOOP("Fields", " %"),
                         .step = 5.0,
                         .decimals = 0,
                         .shownScale = 100.0}),
        field(&S::aim, {.key = "aim",
                        .label = QT_TRANSLATE_NOOP("Fields", "Aims at"),
                        .doc = "what it turns to",
                        .choices = kLightAims}),
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
            .when([](const S& s, const C&) { return s.aim == LightAim::Place; }),
        field(&S::person, {.key = "person",
                           .label = QT_TRANSLATE_NOOP("Fields", "Person"),
                           .doc = "whom it goes with, of \"person\": an id; 0: nobody",
                           .high = 4294967295.0,
                           .role = FieldRole::Individual})
            .when([](const S& s, const C&) { return s.aim == LightAim::Person; }),
        field(&S::group, {.key = "group",
                          .label = QT_TRANSLATE_NOOP("Fields", "Group"),
                          .doc = "of \"group\"; 0: none",
                          .high = 4294967295.0,
                          .role = FieldRole::Group,
                          .zero = QT_TRANSLATE_NOOP("Fields", "choose…")})
            .when([](const S& s, const C&) { return s.aim == LightAim::Group; }));
}

} // namespace crowd::model
