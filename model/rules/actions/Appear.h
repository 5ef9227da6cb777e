// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct Appear
{
    static constexpr KindText kText{.key = "appear",
                                    .name = QT_TRANSLATE_NOOP("Rules", "appear at a place"),
                                    .doc =
                                        "Is at a place from now on, also after leaving the scene.",
                                    .beginsGroup = true};

    PlaceId place = 0;

    static constexpr auto fields()
    {
        return std::tuple(field(&Appear::place, rulefields::place({.doc = "its id"})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<Appear>{QT_TRANSLATE_NOOP("Rules", "appear at {place}")}};
    }
    friend bool operator==(const Appear&, const Appear&) = default;
};

} // namespace crowd::model::actions
