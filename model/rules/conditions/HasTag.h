// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct HasTag
{
    static constexpr KindText kText{.key = "tag",
                                    .name = QT_TRANSLATE_NOOP("Rules", "tagged"),
                                    .doc = "Has a tag.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "is"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "is not"),
                                    .alone = QT_TRANSLATE_NOOP("Rules", "has a tag")};

    std::uint8_t tag = 0;

    static constexpr auto fields()
    {
        return std::tuple(field(&HasTag::tag, rulefields::tag({.doc = "the tag"})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<HasTag>{QT_TRANSLATE_NOOP("Rules", "tagged {tag}"), nullptr,
                                           QT_TRANSLATE_NOOP("Rules", "not tagged {tag}")}};
    }
    friend bool operator==(const HasTag&, const HasTag&) = default;
};

} // namespace crowd::model::conditions
