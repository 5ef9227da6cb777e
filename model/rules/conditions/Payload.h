// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct Payload
{
    static constexpr KindText kText{.key = "payload",
                                    .name = QT_TRANSLATE_NOOP("Rules", "event’s number"),
                                    .doc = "The number that the event carries, compared.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "is"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "is not"),
                                    .alone = QT_TRANSLATE_NOOP("Rules", "the event’s number is…")};

    Comparison comparison = Comparison::More;
    float value = 0.0F;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&Payload::comparison, rulefields::comparison()),
            field(&Payload::value,
                  rulefields::value({.doc = "that it is compared with", .isBeside = true})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Payload>{QT_TRANSLATE_NOOP("Rules", "the event’s number below {value}"),
                              [](const Payload& s) { return s.comparison == Comparison::Less; },
                              QT_TRANSLATE_NOOP("Rules", "the event’s number not below {value}")},
            Sentence<Payload>{QT_TRANSLATE_NOOP("Rules", "the event’s number at {value}"),
                              [](const Payload& s) { return s.comparison == Comparison::Equal; },
                              QT_TRANSLATE_NOOP("Rules", "the event’s number not at {value}")},
            Sentence<Payload>{QT_TRANSLATE_NOOP("Rules", "the event’s number above {value}"),
                              nullptr,
                              QT_TRANSLATE_NOOP("Rules", "the event’s number not above {value}")}};
    }
    friend bool operator==(const Payload&, const Payload&) = default;
};

} // namespace crowd::model::conditions
