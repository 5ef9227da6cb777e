// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct RemoveTag
{
    static constexpr KindText kText{
        .key = "untag", .name = QT_TRANSLATE_NOOP("Rules", "untag"), .doc = "Loses a tag."};

    std::uint8_t tag = 0;

    static constexpr auto fields()
    {
        return std::tuple(field(&RemoveTag::tag, rulefields::tag({.doc = "the tag"})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<RemoveTag>{QT_TRANSLATE_NOOP("Rules", "untag {tag}")}};
    }
    friend bool operator==(const RemoveTag&, const RemoveTag&) = default;
};

} // namespace crowd::model::actions
