// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct TurnTo : AimChoice
{
    static constexpr KindText kText{.key = "turn",
                                    .name = QT_TRANSLATE_NOOP("Rules", "turn to"),
                                    .doc = "Turns to somebody or something."};

    static constexpr auto fields() { return rulefields::aim<TurnTo>(); }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<TurnTo>{QT_TRANSLATE_NOOP("Rules", "turn to whoever it came from"),
                             [](const TurnTo& s) { return s.aim == ActionAim::Sender; }},
            Sentence<TurnTo>{QT_TRANSLATE_NOOP("Rules", "turn to the nearest one tagged {tag}"),
                             [](const TurnTo& s) { return s.aim == ActionAim::Tagged; }},
            Sentence<TurnTo>{QT_TRANSLATE_NOOP("Rules", "turn to the nearest of their {relation}"),
                             [](const TurnTo& s) { return s.aim == ActionAim::Related; }},
            Sentence<TurnTo>{QT_TRANSLATE_NOOP("Rules", "turn to {place}")}};
    }
    friend bool operator==(const TurnTo&, const TurnTo&) = default;
};

} // namespace crowd::model::actions
