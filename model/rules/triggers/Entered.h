// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct Entered
{
    static constexpr KindText kText{.key = "entered",
                                    .name = QT_TRANSLATE_NOOP("Rules", "someone enters"),
                                    .doc = "Somebody comes into a place's circle."};

    PlaceId place = 0; ///< 0: any; kNotChosen

    static constexpr auto fields()
    {
        return std::tuple(field(
            &Entered::place,
            rulefields::place({.doc = "0: any", .zero = QT_TRANSLATE_NOOP("Rules", "any place")})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Entered>{QT_TRANSLATE_NOOP("Rules", "When someone enters {place}")}};
    }
    friend bool operator==(const Entered&, const Entered&) = default;
};

} // namespace crowd::model::triggers
