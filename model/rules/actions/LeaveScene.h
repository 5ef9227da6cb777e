// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct LeaveScene : WantedPlace
{
    static constexpr KindText kText{.key = "leave scene",
                                    .name = QT_TRANSLATE_NOOP("Rules", "leave the scene"),
                                    .doc = "Leaves the scene.",
                                    .isWalk = true};

    static constexpr auto fields()
    {
        return std::tuple(
            computed<LeaveScene, Way>([](const LeaveScene& s) { return s.way(); },
                                      [](LeaveScene& s, Way way) { s.setWay(way); },
                                      {.key = "way", .choices = kWays}),
            field<LeaveScene, PlaceChoice>(&LeaveScene::choice,
                                           {.key = "choice",
                                            .doc = "at which place; given and place 0: where he is",
                                            .choices = kChoices})
                .when([](const LeaveScene&, const FieldContext&) { return false; }),
            field<LeaveScene, PathId>(
                &LeaveScene::path,
                rulefields::path(
                    {.doc = "whose places are meant, of all choices but given; 0: all exits",
                     .zero = QT_TRANSLATE_NOOP("Rules", "of all exits")}))
                .when([](const LeaveScene& s, const FieldContext&) { return !isGiven(s); }),
            field<LeaveScene, PlaceId>(
                &LeaveScene::place,
                rulefields::place(
                    {.doc = "the one that is given, or one whose name those have that are meant"}))
                .when([](const LeaveScene& s, const FieldContext&) {
                    return isGiven(s) && s.place != 0;
                }),
            field<LeaveScene, PlaceId>(
                &LeaveScene::place,
                rulefields::place({.zero = QT_TRANSLATE_NOOP("Rules", "with any name")}))
                .when([](const LeaveScene& s, const FieldContext&) {
                    return !isGiven(s) && s.path == 0;
                }));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<LeaveScene>{QT_TRANSLATE_NOOP("Rules", "leave the scene"),
                                 [](const LeaveScene& s) { return isGiven(s) && s.place == 0; }},
            Sentence<LeaveScene>{QT_TRANSLATE_NOOP("Rules", "leave the scene at {place}"),
                                 [](const LeaveScene& s) { return isGiven(s); }},
            Sentence<LeaveScene>{
                QT_TRANSLATE_NOOP("Rules", "leave the scene at the nearest place of {path}"),
                [](const LeaveScene& s) {
                    return s.choice == PlaceChoice::Nearest && s.path != 0;
                }},
            Sentence<LeaveScene>{
                QT_TRANSLATE_NOOP("Rules", "leave the scene at the nearest place named {place}"),
                [](const LeaveScene& s) {
                    return s.choice == PlaceChoice::Nearest && s.place != 0;
                }},
            Sentence<LeaveScene>{
                QT_TRANSLATE_NOOP("Rules", "leave the scene at the nearest exit"),
                [](const LeaveScene& s) { return s.choice == PlaceChoice::Nearest; }},
            Sentence<LeaveScene>{
                QT_TRANSLATE_NOOP("Rules", "leave the scene at the nearest free place of {path}"),
                [](const LeaveScene& s) {
                    return s.choice == PlaceChoice::NearestFree && s.path != 0;
                }},
            Sentence<LeaveScene>{
                QT_TRANSLATE_NOOP("Rules",
                                  "leave the scene at the nearest free place named {place}"),
                [](const LeaveScene& s) {
                    return s.choice == PlaceChoice::NearestFree && s.place != 0;
                }},
            Sentence<LeaveScene>{
                QT_TRANSLATE_NOOP("Rules", "leave the scene at the nearest free exit"),
                [](const LeaveScene& s) { return s.choice == PlaceChoice::NearestFree; }},
            Sentence<LeaveScene>{
                QT_TRANSLATE_NOOP("Rules", "leave the scene at the first free place of {path}"),
                [](const LeaveScene& s) { return s.path != 0; }},
            Sentence<LeaveScene>{
                QT_TRANSLATE_NOOP("Rules", "leave the scene at the first free place named {place}"),
                [](const LeaveScene& s) { return s.place != 0; }},
            Sentence<LeaveScene>{
                QT_TRANSLATE_NOOP("Rules", "leave the scene at the first free exit")}};
    }
    static constexpr std::array kChoices{FieldChoice{"given", ""}, FieldChoice{"nearest", ""},
                                         FieldChoice{"nearest free", ""},
                                         FieldChoice{"first free", ""}, FieldChoice{"ahead", ""}};
    /// As menus show them.
    enum class Way : std::uint8_t { Here, AtPlace, Nearest, NearestFree, FirstFree, Ahead };
    static constexpr std::array kWays{
        FieldChoice{"here", QT_TRANSLATE_NOOP("Rules", "where they are")},
        FieldChoice{"place", QT_TRANSLATE_NOOP("Rules", "at this place")},
        FieldChoice{"nearest", QT_TRANSLATE_NOOP("Rules", "at the nearest")},
        FieldChoice{"nearest free", QT_TRANSLATE_NOOP("Rules", "at the nearest free one")},
        FieldChoice{"first free", QT_TRANSLATE_NOOP("Rules", "at the first free one")},
        FieldChoice{"ahead", QT_TRANSLATE_NOOP("Rules", "at the first free one"), "", false}};
    static constexpr bool isGiven(const WantedPlace& s) { return s.choice == PlaceChoice::Given; }
    [[nodiscard]] constexpr bool isHere() const { return isGiven(*this) && place == 0; }
    [[nodiscard]] constexpr Way way() const
    {
        return isHere() ? Way::Here : static_cast<Way>(static_cast<int>(choice) + 1);
    }
    constexpr void setWay(Way way)
    {
        const bool isAtOne = way == Way::Here || way == Way::AtPlace;
        choice = isAtOne ? PlaceChoice::Given : static_cast<PlaceChoice>(static_cast<int>(way) - 1);
        path = isAtOne || path == kNotChosen ? 0 : path;
        place = way == Way::AtPlace ? kNotChosen : 0;
    }
    friend bool operator==(const LeaveScene&, const LeaveScene&) = default;
};

} // namespace crowd::model::actions
