// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct SpeedLimit
{
    static constexpr KindText kText{.key = "speed limit",
                                    .name = QT_TRANSLATE_NOOP("Rules", "a speed is passed"),
                                    .doc = "Somebody gets faster or slower than a speed."};

    bool isAbove = true; ///< faster than it, else slower
    float metresPerSecond = 2.0F;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&SpeedLimit::isAbove, {.key = "above",
                                         .doc = "whether he gets faster than it, else slower",
                                         .choices = kSides}),
            field(&SpeedLimit::metresPerSecond,
                  rulefields::numeric({.doc = "the speed, m/s",
                                       .unit = QT_TRANSLATE_NOOP("Rules", " m/s"),
                                       .isBeside = true},
                                      "metresPerSecond", 0.0, 10.0 * kMaxWalkingSpeed, 0.0, 20.0)));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<SpeedLimit>{
                QT_TRANSLATE_NOOP("Rules", "When someone gets faster than {metresPerSecond} m/s"),
                [](const SpeedLimit& s) { return s.isAbove; }},
            Sentence<SpeedLimit>{
                QT_TRANSLATE_NOOP("Rules", "When someone gets slower than {metresPerSecond} m/s")}};
    }
    static constexpr std::array kSides{
        FieldChoice{"false", QT_TRANSLATE_NOOP("Rules", "slower than")},
        FieldChoice{"true", QT_TRANSLATE_NOOP("Rules", "faster than")}};
    friend bool operator==(const SpeedLimit&, const SpeedLimit&) = default;
};

} // namespace crowd::model::triggers
