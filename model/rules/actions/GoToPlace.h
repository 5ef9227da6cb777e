// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct GoToPlace : WantedPlace
{
    static constexpr KindText kText{.key = "go to",
                                    .name = QT_TRANSLATE_NOOP("Rules", "go to a place"),
                                    .doc = "Goes to a place, and on when he is there.",
                                    .isWalk = true};

    static constexpr auto fields()
    {
        return std::tuple(
            field<GoToPlace, PlaceChoice>(
                &GoToPlace::choice, {.key = "choice", .doc = "which place", .choices = kChoices}),
            field<GoToPlace, PathId>(
                &GoToPlace::path,
                rulefields::path({.doc = "whose places are meant, of all choices but given; 0: any",
                                  .zero = QT_TRANSLATE_NOOP("Rules", "of any path")}))
                .when([](const GoToPlace& s, const FieldContext&) { return !isGiven(s); }),
            field<GoToPlace, PlaceId>(
                &GoToPlace::place,
                rulefields::place(
                    {.doc = "the one that is given, or one whose name those have that are meant",
                     .isBeside = true}))
                .when([](const GoToPlace& s, const FieldContext&) { return isGiven(s); }),
            field<GoToPlace, PlaceId>(
                &GoToPlace::place,
                rulefields::place(
                    {.isBeside = true, .zero = QT_TRANSLATE_NOOP("Rules", "with any name")}))
                .when([](const GoToPlace& s, const FieldContext&) {
                    return !isGiven(s) && s.path == 0;
                }));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<GoToPlace>{QT_TRANSLATE_NOOP("Rules", "go to {place}"),
                                [](const GoToPlace& s) { return isGiven(s); }},
            Sentence<GoToPlace>{
                QT_TRANSLATE_NOOP("Rules", "go to the nearest place of {path}"),
                [](const GoToPlace& s) { return s.choice == PlaceChoice::Nearest && s.path != 0; }},
            Sentence<GoToPlace>{QT_TRANSLATE_NOOP("Rules", "go to the nearest place named {place}"),
                                [](const GoToPlace& s) {
                                    return s.choice == PlaceChoice::Nearest && s.place != 0;
                                }},
            Sentence<GoToPlace>{
                QT_TRANSLATE_NOOP("Rules", "go to the nearest place"),
                [](const GoToPlace& s) { return s.choice == PlaceChoice::Nearest; }},
            Sentence<GoToPlace>{
                QT_TRANSLATE_NOOP("Rules", "go to the nearest free place of {path}"),
                [](const GoToPlace& s) {
                    return s.choice == PlaceChoice::NearestFree && s.path != 0;
                }},
            Sentence<GoToPlace>{
                QT_TRANSLATE_NOOP("Rules", "go to the nearest free place named {place}"),
                [](const GoToPlace& s) {
                    return s.choice == PlaceChoice::NearestFree && s.place != 0;
                }},
            Sentence<GoToPlace>{
                QT_TRANSLATE_NOOP("Rules", "go to the nearest free place"),
                [](const GoToPlace& s) { return s.choice == PlaceChoice::NearestFree; }},
            Sentence<GoToPlace>{QT_TRANSLATE_NOOP("Rules", "go to the first free place of {path}"),
                                [](const GoToPlace& s) {
                                    return s.choice == PlaceChoice::FirstFree && s.path != 0;
                                }},
            Sentence<GoToPlace>{
                QT_TRANSLATE_NOOP("Rules", "go to the first free place named {place}"),
                [](const GoToPlace& s) {
                    return s.choice == PlaceChoice::FirstFree && s.place != 0;
                }},
            Sentence<GoToPlace>{
                QT_TRANSLATE_NOOP("Rules", "go to the first free place"),
                [](const GoToPlace& s) { return s.choice == PlaceChoice::FirstFree; }},
            Sentence<GoToPlace>{
                QT_TRANSLATE_NOOP("Rules", "move up to the next free place of {path}"),
                [](const GoToPlace& s) { return s.path != 0; }},
            Sentence<GoToPlace>{
                QT_TRANSLATE_NOOP("Rules", "move up to the next free place named {place}"),
                [](const GoToPlace& s) { return s.place != 0; }},
            Sentence<GoToPlace>{QT_TRANSLATE_NOOP("Rules", "move up to the next free place")}};
    }
    static constexpr std::array kChoices{
        FieldChoice{"given", QT_TRANSLATE_NOOP("Rules", "this place")},
        FieldChoice{"nearest", QT_TRANSLATE_NOOP("Rules", "the nearest")},
        FieldChoice{"nearest free", QT_TRANSLATE_NOOP("Rules", "the nearest free one")},
        FieldChoice{"first free", QT_TRANSLATE_NOOP("Rules", "the first free one")},
        FieldChoice{"ahead", QT_TRANSLATE_NOOP("Rules", "the one ahead, when free")}};
    static constexpr bool isGiven(const WantedPlace& s) { return s.choice == PlaceChoice::Given; }
    friend bool operator==(const GoToPlace&, const GoToPlace&) = default;
};

} // namespace crowd::model::actions
