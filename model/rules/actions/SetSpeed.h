// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct SetSpeed
{
    static constexpr KindText kText{.key = "speed",
                                    .name = QT_TRANSLATE_NOOP("Rules", "set the speed"),
                                    .doc = "Walks so fast from now on."};

    float value = 0.0F; ///< m/s; 0: the payload of the event

    [[nodiscard]] bool takesPayload() const { return value <= 0.0F; }
    static constexpr auto fields()
    {
        return std::tuple(
            field(&SetSpeed::value,
                  rulefields::value({.label = QT_TRANSLATE_NOOP("Rules", "to"),
                                     .doc = "m/s; 0: the number of the event",
                                     .unit = QT_TRANSLATE_NOOP("Rules", " m/s"),
                                     .sliderLow = 0.0,
                                     .sliderHigh = 10.0,
                                     .zero = QT_TRANSLATE_NOOP("Rules", "the event’s number")})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<SetSpeed>{QT_TRANSLATE_NOOP("Rules", "at {value} m/s"),
                                             [](const SetSpeed& s) { return s.value > 0.0F; }},
                          Sentence<SetSpeed>{QT_TRANSLATE_NOOP("Rules", "at the event’s speed")}};
    }
    friend bool operator==(const SetSpeed&, const SetSpeed&) = default;
};

} // namespace crowd::model::actions
