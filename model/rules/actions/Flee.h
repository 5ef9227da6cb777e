// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct Flee : AimChoice
{
    static constexpr KindText kText{.key = "flee",
                                    .name = QT_TRANSLATE_NOOP("Rules", "run away"),
                                    .doc = "Goes away from somebody or something.",
                                    .isWalk = true};

    float metres = 2.0F;

    /// Where it comes from nobody he runs anywhere.
    static constexpr bool kNeedsSender = false;

    static constexpr auto fields()
    {
        return std::tuple_cat(
            rulefields::aim<Flee>(),
            std::tuple(
                field(&Flee::metres, rulefields::metres({.label = QT_TRANSLATE_NOOP("Rules", "for"),
                                                         .doc = "how far"}))));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Flee>{
                QT_TRANSLATE_NOOP("Rules",
                                  "run {metres} m away from whoever it came from, or anywhere"),
                [](const Flee& s) { return s.aim == ActionAim::Sender; }},
            Sentence<Flee>{
                QT_TRANSLATE_NOOP("Rules", "run {metres} m away from the nearest one tagged {tag}"),
                [](const Flee& s) { return s.aim == ActionAim::Tagged; }},
            Sentence<Flee>{QT_TRANSLATE_NOOP(
                               "Rules", "run {metres} m away from the nearest of their {relation}"),
                           [](const Flee& s) { return s.aim == ActionAim::Related; }},
            Sentence<Flee>{QT_TRANSLATE_NOOP("Rules", "run {metres} m away from {place}")}};
    }
    friend bool operator==(const Flee&, const Flee&) = default;
};

} // namespace crowd::model::actions
