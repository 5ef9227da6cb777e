// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct InPlace
{
    static constexpr KindText kText{.key = "in place",
                                    .name = QT_TRANSLATE_NOOP("Rules", "inside place"),
                                    .doc = "Is in a place's circle.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "is"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "is not"),
                                    .alone = QT_TRANSLATE_NOOP("Rules", "is inside a place")};

    PlaceId place = 0;

    static constexpr auto fields()
    {
        return std::tuple(field(&InPlace::place, rulefields::place({.doc = "its id"})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<InPlace>{QT_TRANSLATE_NOOP("Rules", "in {place}"), nullptr,
                                            QT_TRANSLATE_NOOP("Rules", "not in {place}")}};
    }
    friend bool operator==(const InPlace&, const InPlace&) = default;
};

} // namespace crowd::model::conditions
