// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct Chance
{
    static constexpr KindText kText{.key = "chance",
                                    .name = QT_TRANSLATE_NOOP("Rules", "by chance"),
                                    .doc = "Holds in a share of cases, drawn anew each time.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "happens"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "does not happen")};

    float chance = 0.5F; ///< 0..1

    static constexpr auto fields()
    {
        return std::tuple(field(
            &Chance::chance, rulefields::numeric({.label = QT_TRANSLATE_NOOP("Rules", "in"),
                                                  .doc = "the share",
                                                  .unit = QT_TRANSLATE_NOOP("Rules", " % of cases"),
                                                  .sliderLow = 0.0,
                                                  .sliderHigh = 100.0,
                                                  .shownScale = 100.0},
                                                 "chance", 0.0, 1.0)));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<Chance>{
            QT_TRANSLATE_NOOP("Rules", "by chance in {chance} % of cases"), nullptr,
            QT_TRANSLATE_NOOP("Rules", "except by chance in {chance} % of cases")}};
    }
    friend bool operator==(const Chance&, const Chance&) = default;
};

} // namespace crowd::model::conditions
