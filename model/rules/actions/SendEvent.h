// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model {

/// Whom a sent event reaches.
enum class EventReach : std::uint8_t { Self, Near, Tagged, Group, Everybody, Related };

inline constexpr std::array kEventReaches{
    FieldChoice{"self", QT_TRANSLATE_NOOP("Rules", "themselves")},
    FieldChoice{"near", QT_TRANSLATE_NOOP("Rules", "those near")},
    FieldChoice{"tagged", QT_TRANSLATE_NOOP("Rules", "those tagged")},
    FieldChoice{"group", QT_TRANSLATE_NOOP("Rules", "their group")},
    FieldChoice{"everybody", QT_TRANSLATE_NOOP("Rules", "everybody")},
    FieldChoice{"related", QT_TRANSLATE_NOOP("Rules", "all of their")}};

} // namespace crowd::model

namespace crowd::model::actions {

struct SendEvent
{
    static constexpr KindText kText{.key = "send",
                                    .name = QT_TRANSLATE_NOOP("Rules", "send an event"),
                                    .doc =
                                        "Sends an event, which arrives in the next step or later.",
                                    .beginsGroup = true};

    std::string event;
    EventReach reach = EventReach::Near;
    float metres = 2.0F;          ///< Near
    std::uint8_t tag = 0;         ///< Tagged
    float secondsPerMetre = 0.0F; ///< so that a wave runs
    float value = 0.0F;           ///< payload
    std::uint32_t relation = 0;   ///< Related: RelationKindId, 0: any

    static constexpr auto fields()
    {
        return std::tuple(
            field(&SendEvent::event, rulefields::event({.doc = "its name"})),
            field(&SendEvent::reach, {.key = "reach",
                                      .doc = "whom it reaches",
                                      .choices = kEventReaches,
                                      .isBeside = true}),
            field(
                &SendEvent::metres,
                rulefields::metres({.label = QT_TRANSLATE_NOOP("Rules", "within"),
                                    .tip = QT_TRANSLATE_NOOP("Rules", "Whoever is nearer hears it"),
                                    .doc = "how near those are who are near"}))
                .when([](const SendEvent& s, const FieldContext&) {
                    return s.reach == EventReach::Near;
                }),
            field(&SendEvent::tag, rulefields::tag({.doc = "of those tagged"}))
                .when([](const SendEvent& s, const FieldContext&) {
                    return s.reach == EventReach::Tagged;
                }),
            field(&SendEvent::relation,
                  rulefields::relation({.doc = "of those related; 0: any", .isBeside = true}))
                .when([](const SendEvent& s, const FieldContext&) {
                    return s.reach == EventReach::Related;
                }),
            field(&SendEvent::secondsPerMetre,
                  rulefields::numeric(
                      {.label = QT_TRANSLATE_NOOP("Rules", "runs at"),
                       .tip = QT_TRANSLATE_NOOP("Rules", "How long it takes from one to the next"),
                       .doc = "how long it takes to get there, s/m",
                       .unit = QT_TRANSLATE_NOOP("Rules", " s/m"),
                       .zero = QT_TRANSLATE_NOOP("Rules", "once for all")},
                      "secondsPerMetre", 0.0, kMaxSeconds, 0.0, 60.0)),
            field(&SendEvent::value,
                  rulefields::value(
                      {.label = QT_TRANSLATE_NOOP("Rules", "with the number"),
                       .tip = QT_TRANSLATE_NOOP(
                           "Rules", "Rules that hear it can ask for it, or walk as fast"),
                       .doc = "the number that it carries"})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<SendEvent>{QT_TRANSLATE_NOOP("Rules", "send “{event}” to themselves"),
                                [](const SendEvent& s) { return s.reach == EventReach::Self; }},
            Sentence<SendEvent>{
                QT_TRANSLATE_NOOP("Rules", "send “{event}” to those within {metres} m"),
                [](const SendEvent& s) { return s.reach == EventReach::Near; }},
            Sentence<SendEvent>{QT_TRANSLATE_NOOP("Rules", "send “{event}” to those tagged {tag}"),
                                [](const SendEvent& s) { return s.reach == EventReach::Tagged; }},
            Sentence<SendEvent>{QT_TRANSLATE_NOOP("Rules", "send “{event}” to their group"),
                                [](const SendEvent& s) { return s.reach == EventReach::Group; }},
            Sentence<SendEvent>{QT_TRANSLATE_NOOP("Rules", "send “{event}” to their {relation}"),
                                [](const SendEvent& s) { return s.reach == EventReach::Related; }},
            Sentence<SendEvent>{QT_TRANSLATE_NOOP("Rules", "send “{event}” to everybody")}};
    }
    friend bool operator==(const SendEvent&, const SendEvent&) = default;
};

} // namespace crowd::model::actions
