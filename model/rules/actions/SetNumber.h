// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct SetNumber
{
    static constexpr KindText kText{.key = "set number",
                                    .name = QT_TRANSLATE_NOOP("Rules", "set a number"),
                                    .doc = "Sets an artist's number of his."};

    NumberId number = 0;
    float value = 0.0F;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&SetNumber::number, rulefields::number({.doc = "its id"})),
            field(&SetNumber::value, rulefields::value({.label = QT_TRANSLATE_NOOP("Rules", "to"),
                                                        .doc = "what it becomes",
                                                        .isBeside = true})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<SetNumber>{QT_TRANSLATE_NOOP("Rules", "set {number} to {value}")}};
    }
    friend bool operator==(const SetNumber&, const SetNumber&) = default;
};

} // namespace crowd::model::actions
