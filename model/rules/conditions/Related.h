// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct Related
{
    static constexpr KindText kText{
        .key = "related",
        .name = QT_TRANSLATE_NOOP("Rules", "number of those related"),
        .doc = "How many are related to him, whichever way, and have "
               "not left, compared.",
        .yes = QT_TRANSLATE_NOOP("Rules", "is"),
        .no = QT_TRANSLATE_NOOP("Rules", "is not"),
        .alone = QT_TRANSLATE_NOOP("Rules", "the number of those related is…")};

    std::uint32_t relation = 0; ///< RelationKindId, 0: any
    Comparison comparison = Comparison::More;
    float value = 0.0F;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&Related::relation, rulefields::relation({.doc = "by which; 0: any"})),
            field(&Related::comparison, rulefields::comparison()),
            field(&Related::value,
                  rulefields::value({.doc = "that it is compared with", .isBeside = true})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Related>{
                QT_TRANSLATE_NOOP("Rules", "the number of their {relation} below {value}"),
                [](const Related& s) { return s.comparison == Comparison::Less; },
                QT_TRANSLATE_NOOP("Rules", "the number of their {relation} not below {value}")},
            Sentence<Related>{
                QT_TRANSLATE_NOOP("Rules", "the number of their {relation} at {value}"),
                [](const Related& s) { return s.comparison == Comparison::Equal; },
                QT_TRANSLATE_NOOP("Rules", "the number of their {relation} not at {value}")},
            Sentence<Related>{
                QT_TRANSLATE_NOOP("Rules", "the number of their {relation} above {value}"), nullptr,
                QT_TRANSLATE_NOOP("Rules", "the number of their {relation} not above {value}")}};
    }
    friend bool operator==(const Related&, const Related&) = default;
};

} // namespace crowd::model::conditions
