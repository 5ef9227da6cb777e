// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct Left
{
    static constexpr KindText kText{.key = "left",
                                    .name = QT_TRANSLATE_NOOP("Rules", "someone leaves"),
                                    .doc = "Somebody comes out of a place's circle."};

    PlaceId place = 0; ///< 0: any; kNotChosen

    static constexpr auto fields()
    {
        return std::tuple(field(
            &Left::place,
            rulefields::place({.doc = "0: any", .zero = QT_TRANSLATE_NOOP("Rules", "any place")})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Left>{QT_TRANSLATE_NOOP("Rules", "When someone leaves {place}")}};
    }
    friend bool operator==(const Left&, const Left&) = default;
};

} // namespace crowd::model::triggers
