// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct AddTag
{
    static constexpr KindText kText{
        .key = "tag", .name = QT_TRANSLATE_NOOP("Rules", "tag"), .doc = "Gets a tag."};

    std::uint8_t tag = 0;

    static constexpr auto fields()
    {
        return std::tuple(field(&AddTag::tag, rulefields::tag({.doc = "the tag"})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<AddTag>{QT_TRANSLATE_NOOP("Rules", "tag {tag}")}};
    }
    friend bool operator==(const AddTag&, const AddTag&) = default;
};

} // namespace crowd::model::actions
