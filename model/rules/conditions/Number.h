// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct Number
{
    static constexpr KindText kText{.key = "number",
                                    .name = QT_TRANSLATE_NOOP("Rules", "own number"),
                                    .doc = "An artist's number of his, compared.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "is"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "is not"),
                                    .alone = QT_TRANSLATE_NOOP("Rules", "their own number is…")};

    NumberId number = 0;
    Comparison comparison = Comparison::More;
    float value = 0.0F;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&Number::number, rulefields::number({.doc = "its id"})),
            field(&Number::comparison, rulefields::comparison()),
            field(&Number::value,
                  rulefields::value({.doc = "that it is compared with", .isBeside = true})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Number>{QT_TRANSLATE_NOOP("Rules", "{number} below {value}"),
                             [](const Number& s) { return s.comparison == Comparison::Less; },
                             QT_TRANSLATE_NOOP("Rules", "{number} not below {value}")},
            Sentence<Number>{QT_TRANSLATE_NOOP("Rules", "{number} at {value}"),
                             [](const Number& s) { return s.comparison == Comparison::Equal; },
                             QT_TRANSLATE_NOOP("Rules", "{number} not at {value}")},
            Sentence<Number>{QT_TRANSLATE_NOOP("Rules", "{number} above {value}"), nullptr,
                             QT_TRANSLATE_NOOP("Rules", "{number} not above {value}")}};
    }
    friend bool operator==(const Number&, const Number&) = default;
};

} // namespace crowd::model::conditions
