// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct Waited
{
    static constexpr KindText kText{.key = "waited",
                                    .name = QT_TRANSLATE_NOOP("Rules", "someone has stood for"),
                                    .doc = "Somebody has stood still for so long."};

    float seconds = 5.0F;

    static constexpr auto fields()
    {
        return std::tuple(field(
            &Waited::seconds,
            rulefields::seconds({.doc = "how long", .sliderLow = 0.1, .sliderHigh = 3600.0})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Waited>{QT_TRANSLATE_NOOP("Rules", "When someone has stood for {seconds} s")}};
    }
    friend bool operator==(const Waited&, const Waited&) = default;
};

} // namespace crowd::model::triggers
