// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct SitDown
{
    static constexpr KindText kText{.key = "sit down",
                                    .name = QT_TRANSLATE_NOOP("Rules", "sit on a free seat"),
                                    .doc = "Goes to the nearest free seat and sits down.",
                                    .isWalk = true};

    float metres = 2.0F; ///< 0: however far

    static constexpr auto fields()
    {
        return std::tuple(
            field(&SitDown::metres,
                  rulefields::metres({.label = QT_TRANSLATE_NOOP("Rules", "within"),
                                      .doc = "how far the seat may be; 0: however far",
                                      .zero = QT_TRANSLATE_NOOP("Rules", "however far")})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<SitDown>{
                QT_TRANSLATE_NOOP("Rules", "sit on the nearest free seat within {metres} m"),
                [](const SitDown& s) { return s.metres > 0.0F; }},
            Sentence<SitDown>{QT_TRANSLATE_NOOP("Rules", "sit on the nearest free seat")}};
    }
    void suit() { metres = 0.0F; }
    friend bool operator==(const SitDown&, const SitDown&) = default;
};

} // namespace crowd::model::actions
