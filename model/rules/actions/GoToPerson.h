// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct GoToPerson : AimChoice
{
    static constexpr KindText kText{.key = "go to person",
                                    .name = QT_TRANSLATE_NOOP("Rules", "go to someone"),
                                    .doc = "Goes to somebody, who may walk himself.",
                                    .isWalk = true};

    float metres = 2.0F;  ///< how near he comes
    float seconds = 3.0F; ///< gives up after so long; 0: never

    static constexpr auto fields()
    {
        return std::tuple_cat(
            rulefields::personAim<GoToPerson>(),
            std::tuple(
                field(&GoToPerson::metres,
                      rulefields::metres({.label = QT_TRANSLATE_NOOP("Rules", "up to"),
                                          .tip = QT_TRANSLATE_NOOP("Rules", "How near they come"),
                                          .doc = "how near he comes",
                                          .sliderLow = 0.0,
                                          .sliderHigh = 100.0})),
                field(&GoToPerson::seconds,
                      rulefields::seconds({.label = QT_TRANSLATE_NOOP("Rules", "at most"),
                                           .doc = "gives up after so long; 0: never",
                                           .zero = QT_TRANSLATE_NOOP("Rules", "however long")}))));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<GoToPerson>{QT_TRANSLATE_NOOP("Rules", "go to whoever it came from"),
                                 [](const GoToPerson& s) { return s.aim == ActionAim::Sender; }},
            Sentence<GoToPerson>{QT_TRANSLATE_NOOP("Rules", "go to the nearest one tagged {tag}"),
                                 [](const GoToPerson& s) { return s.aim == ActionAim::Tagged; }},
            Sentence<GoToPerson>{
                QT_TRANSLATE_NOOP("Rules", "go to the nearest of their {relation}"),
                [](const GoToPerson& s) { return s.aim == ActionAim::Related; }},
            Sentence<GoToPerson>{QT_TRANSLATE_NOOP("Rules", "go to {place}")}};
    }
    void suit()
    {
        metres = 1.5F;
        seconds = 0.0F;
        aim = aim == ActionAim::Place ? ActionAim::Sender : aim;
    }
    friend bool operator==(const GoToPerson&, const GoToPerson&) = default;
};

} // namespace crowd::model::actions
