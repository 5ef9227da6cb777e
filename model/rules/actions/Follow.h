// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct Follow : AimChoice
{
    static constexpr KindText kText{.key = "follow person",
                                    .name = QT_TRANSLATE_NOOP("Rules", "follow someone"),
                                    .doc = "Stays near somebody who walks.",
                                    .isWalk = true};

    float metres = 2.0F;  ///< how near he comes
    float seconds = 3.0F; ///< how long; 0: until another rule comes

    static constexpr auto fields()
    {
        return std::tuple_cat(
            rulefields::personAim<Follow>(),
            std::tuple(
                field(&Follow::metres,
                      rulefields::metres({.label = QT_TRANSLATE_NOOP("Rules", "up to"),
                                          .tip = QT_TRANSLATE_NOOP("Rules", "How near they come"),
                                          .doc = "how near he comes",
                                          .sliderLow = 0.0,
                                          .sliderHigh = 100.0})),
                field(&Follow::seconds,
                      rulefields::seconds(
                          {.label = QT_TRANSLATE_NOOP("Rules", "for"),
                           .doc = "how long; 0: until another rule comes",
                           .zero = QT_TRANSLATE_NOOP("Rules", "until something else comes")}))));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Follow>{
                QT_TRANSLATE_NOOP("Rules", "follow whoever it came from for {seconds} s"),
                [](const Follow& s) { return s.aim == ActionAim::Sender && s.seconds > 0.0F; }},
            Sentence<Follow>{QT_TRANSLATE_NOOP(
                                 "Rules", "follow whoever it came from until something else comes"),
                             [](const Follow& s) { return s.aim == ActionAim::Sender; }},
            Sentence<Follow>{
                QT_TRANSLATE_NOOP("Rules", "follow the nearest one tagged {tag} for {seconds} s"),
                [](const Follow& s) { return s.aim == ActionAim::Tagged && s.seconds > 0.0F; }},
            Sentence<Follow>{
                QT_TRANSLATE_NOOP("Rules",
                                  "follow the nearest one tagged {tag} until something else comes"),
                [](const Follow& s) { return s.aim == ActionAim::Tagged; }},
            Sentence<Follow>{
                QT_TRANSLATE_NOOP("Rules",
                                  "follow the nearest of their {relation} for {seconds} s"),
                [](const Follow& s) { return s.aim == ActionAim::Related && s.seconds > 0.0F; }},
            Sentence<Follow>{
                QT_TRANSLATE_NOOP(
                    "Rules", "follow the nearest of their {relation} until something else comes"),
                [](const Follow& s) { return s.aim == ActionAim::Related; }},
            Sentence<Follow>{QT_TRANSLATE_NOOP("Rules", "follow {place} for {seconds} s"),
                             [](const Follow& s) { return s.seconds > 0.0F; }},
            Sentence<Follow>{
                QT_TRANSLATE_NOOP("Rules", "follow {place} until something else comes")}};
    }
    void suit()
    {
        // A whole arm's length further than two who talk: whom many follow must get out.
        metres = 2.5F;
        seconds = 0.0F;
        aim = aim == ActionAim::Place ? ActionAim::Sender : aim;
    }
    friend bool operator==(const Follow&, const Follow&) = default;
};

} // namespace crowd::model::actions
