// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct Speed
{
    static constexpr KindText kText{.key = "speed",
                                    .name = QT_TRANSLATE_NOOP("Rules", "speed"),
                                    .doc = "How fast he goes over the ground, m/s, compared.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "is"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "is not"),
                                    .alone = QT_TRANSLATE_NOOP("Rules", "their speed is…")};

    Comparison comparison = Comparison::More;
    float value = 0.0F;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&Speed::comparison, rulefields::comparison()),
            field(&Speed::value, rulefields::value({.doc = "that it is compared with",
                                                    .unit = QT_TRANSLATE_NOOP("Rules", " m/s"),
                                                    .isBeside = true})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Speed>{QT_TRANSLATE_NOOP("Rules", "speed below {value}"),
                            [](const Speed& s) { return s.comparison == Comparison::Less; },
                            QT_TRANSLATE_NOOP("Rules", "speed not below {value}")},
            Sentence<Speed>{QT_TRANSLATE_NOOP("Rules", "speed at {value}"),
                            [](const Speed& s) { return s.comparison == Comparison::Equal; },
                            QT_TRANSLATE_NOOP("Rules", "speed not at {value}")},
            Sentence<Speed>{QT_TRANSLATE_NOOP("Rules", "speed above {value}"), nullptr,
                            QT_TRANSLATE_NOOP("Rules", "speed not above {value}")}};
    }
    friend bool operator==(const Speed&, const Speed&) = default;
};

} // namespace crowd::model::conditions
