// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct IsFull
{
    static constexpr KindText kText{.key = "full",
                                    .name = QT_TRANSLATE_NOOP("Rules", "full: the place"),
                                    .doc = "A place has no room left.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "is"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "is not"),
                                    .alone = QT_TRANSLATE_NOOP("Rules", "a place is full")};

    PlaceId place = 0;

    static constexpr auto fields()
    {
        return std::tuple(field(&IsFull::place, rulefields::place({.doc = "its id"})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<IsFull>{QT_TRANSLATE_NOOP("Rules", "{place} full"), nullptr,
                                           QT_TRANSLATE_NOOP("Rules", "{place} not full")}};
    }
    friend bool operator==(const IsFull&, const IsFull&) = default;
};

} // namespace crowd::model::conditions
