// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct PeopleIn
{
    static constexpr KindText kText{
        .key = "people in",
        .name = QT_TRANSLATE_NOOP("Rules", "number of characters in"),
        .doc = "How many are in a place, compared.",
        .yes = QT_TRANSLATE_NOOP("Rules", "is"),
        .no = QT_TRANSLATE_NOOP("Rules", "is not"),
        .alone = QT_TRANSLATE_NOOP("Rules", "the number of characters in a place is…")};

    PlaceId place = 0;
    Comparison comparison = Comparison::More;
    float value = 0.0F;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&PeopleIn::place, rulefields::place({.doc = "its id"})),
            field(&PeopleIn::comparison, rulefields::comparison()),
            field(&PeopleIn::value,
                  rulefields::value({.doc = "that it is compared with", .isBeside = true})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<PeopleIn>{
                QT_TRANSLATE_NOOP("Rules", "characters in {place} below {value}"),
                [](const PeopleIn& s) { return s.comparison == Comparison::Less; },
                QT_TRANSLATE_NOOP("Rules", "characters in {place} not below {value}")},
            Sentence<PeopleIn>{QT_TRANSLATE_NOOP("Rules", "characters in {place} at {value}"),
                               [](const PeopleIn& s) { return s.comparison == Comparison::Equal; },
                               QT_TRANSLATE_NOOP("Rules", "characters in {place} not at {value}")},
            Sentence<PeopleIn>{
                QT_TRANSLATE_NOOP("Rules", "characters in {place} above {value}"), nullptr,
                QT_TRANSLATE_NOOP("Rules", "characters in {place} not above {value}")}};
    }
    friend bool operator==(const PeopleIn&, const PeopleIn&) = default;
};

} // namespace crowd::model::conditions
