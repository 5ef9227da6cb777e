// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct LookAt : AimChoice
{
    static constexpr KindText kText{.key = "look at",
                                    .name = QT_TRANSLATE_NOOP("Rules", "look at"),
                                    .doc = "Keeps facing somebody or something."};

    float seconds = 3.0F; ///< 0: until another rule comes

    static constexpr auto fields()
    {
        return std::tuple_cat(
            rulefields::aim<LookAt>(),
            std::tuple(field(&LookAt::seconds,
                             rulefields::seconds({.label = QT_TRANSLATE_NOOP("Rules", "for"),
                                                  .doc = "how long; 0: until another rule comes",
                                                  .zero = QT_TRANSLATE_NOOP(
                                                      "Rules", "until something else comes")}))));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<LookAt>{
                QT_TRANSLATE_NOOP("Rules", "look at whoever it came from for {seconds} s"),
                [](const LookAt& s) { return s.aim == ActionAim::Sender && s.seconds > 0.0F; }},
            Sentence<LookAt>{
                QT_TRANSLATE_NOOP("Rules",
                                  "look at whoever it came from until something else comes"),
                [](const LookAt& s) { return s.aim == ActionAim::Sender; }},
            Sentence<LookAt>{
                QT_TRANSLATE_NOOP("Rules", "look at the nearest one tagged {tag} for {seconds} s"),
                [](const LookAt& s) { return s.aim == ActionAim::Tagged && s.seconds > 0.0F; }},
            Sentence<LookAt>{
                QT_TRANSLATE_NOOP(
                    "Rules", "look at the nearest one tagged {tag} until something else comes"),
                [](const LookAt& s) { return s.aim == ActionAim::Tagged; }},
            Sentence<LookAt>{
                QT_TRANSLATE_NOOP("Rules",
                                  "look at the nearest of their {relation} for {seconds} s"),
                [](const LookAt& s) { return s.aim == ActionAim::Related && s.seconds > 0.0F; }},
            Sentence<LookAt>{
                QT_TRANSLATE_NOOP(
                    "Rules", "look at the nearest of their {relation} until something else comes"),
                [](const LookAt& s) { return s.aim == ActionAim::Related; }},
            Sentence<LookAt>{QT_TRANSLATE_NOOP("Rules", "look at {place} for {seconds} s"),
                             [](const LookAt& s) { return s.seconds > 0.0F; }},
            Sentence<LookAt>{
                QT_TRANSLATE_NOOP("Rules", "look at {place} until something else comes")}};
    }
    friend bool operator==(const LookAt&, const LookAt&) = default;
};

} // namespace crowd::model::actions
