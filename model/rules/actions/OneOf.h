// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct OneOf
{
    static constexpr KindText kText{
        .key = "one of",
        .name = QT_TRANSLATE_NOOP("Rules", "one of these"),
        .doc = "One alternative of a choice, drawn by weight: several of them, each with the "
               "deeper actions below it, make the choice.",
        .hasParts = true};

    float weight = 1.0F; ///< against the other alternatives

    static constexpr auto fields()
    {
        return std::tuple(
            field(&OneOf::weight,
                  rulefields::numeric(
                      {.label = QT_TRANSLATE_NOOP("Rules", "how often"),
                       .tip = QT_TRANSLATE_NOOP("Rules", "How often it comes, against the others"),
                       .doc = "how often it comes, against the others",
                       .unit = QT_TRANSLATE_NOOP("Rules", " ×")},
                      "weight", 0.0, kMaxNumber, 0.0, 1000.0)));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<OneOf>{QT_TRANSLATE_NOOP("Rules", "{inside}")}};
    }
    void suit() { weight = 1.0F; }
    friend bool operator==(const OneOf&, const OneOf&) = default;
};

} // namespace crowd::model::actions
