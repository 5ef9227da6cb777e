// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct AddToNumber
{
    static constexpr KindText kText{.key = "add to number",
                                    .name = QT_TRANSLATE_NOOP("Rules", "add to a number"),
                                    .doc = "Adds to an artist's number of his."};

    NumberId number = 0;
    float value = 0.0F;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&AddToNumber::number, rulefields::number({.doc = "its id"})),
            field(&AddToNumber::value, rulefields::value({.label = QT_TRANSLATE_NOOP("Rules", "by"),
                                                          .doc = "what is added",
                                                          .isBeside = true})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<AddToNumber>{QT_TRANSLATE_NOOP("Rules", "add {value} to {number}")}};
    }
    friend bool operator==(const AddToNumber&, const AddToNumber&) = default;
};

} // namespace crowd::model::actions
