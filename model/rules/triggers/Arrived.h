// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct Arrived
{
    static constexpr KindText kText{.key = "arrived",
                                    .name = QT_TRANSLATE_NOOP("Rules", "someone arrives at"),
                                    .doc = "Somebody reaches the place that he was going to."};

    PlaceId place = 0; ///< 0: any; kNotChosen

    static constexpr auto fields()
    {
        return std::tuple(field(
            &Arrived::place,
            rulefields::place({.doc = "0: any", .zero = QT_TRANSLATE_NOOP("Rules", "any place")})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Arrived>{QT_TRANSLATE_NOOP("Rules", "When someone arrives at {place}")}};
    }
    friend bool operator==(const Arrived&, const Arrived&) = default;
};

} // namespace crowd::model::triggers
