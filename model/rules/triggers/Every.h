// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct Every
{
    static constexpr KindText kText{.key = "every",
                                    .name = QT_TRANSLATE_NOOP("Rules", "every so often"),
                                    .doc = "Again and again, for each at other times."};

    float seconds = 5.0F;
    float jitter = 0.2F; ///< share of the time, 0..1

    static constexpr auto fields()
    {
        return std::tuple(
            field(&Every::seconds,
                  rulefields::seconds(
                      {.doc = "between two times", .sliderLow = 0.1, .sliderHigh = 3600.0})),
            field(&Every::jitter,
                  rulefields::numeric(
                      {.doc = "how much earlier or later it may be, as a share of the time"},
                      "jitter", 0.0, 1.0))
                .when([](const Every&, const FieldContext&) { return false; }));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<Every>{QT_TRANSLATE_NOOP("Rules", "Every {seconds} s")}};
    }
    friend bool operator==(const Every&, const Every&) = default;
};

} // namespace crowd::model::triggers
