// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct TagNear
{
    static constexpr KindText kText{.key = "tag near",
                                    .name = QT_TRANSLATE_NOOP("Rules", "someone tagged is near"),
                                    .doc = "Somebody with a tag comes near."};

    std::uint8_t tag = 0;
    float metres = 3.0F;

    static constexpr auto fields()
    {
        return std::tuple(field(&TagNear::tag, rulefields::tag({.doc = "of who comes near"})),
                          field(&TagNear::metres,
                                rulefields::metres({.label = QT_TRANSLATE_NOOP("Rules", "within"),
                                                    .doc = "how near",
                                                    .sliderLow = 0.1,
                                                    .sliderHigh = 100.0,
                                                    .isBeside = true})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<TagNear>{
            QT_TRANSLATE_NOOP("Rules", "When someone tagged {tag} comes within {metres} m")}};
    }
    friend bool operator==(const TagNear&, const TagNear&) = default;
};

} // namespace crowd::model::triggers
