// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct HasFeature
{
    static constexpr KindText kText{.key = "feature",
                                    .name = QT_TRANSLATE_NOOP("Rules", "of a feature"),
                                    .doc = "Bears a value of a feature.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "is"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "is not"),
                                    .alone =
                                        QT_TRANSLATE_NOOP("Rules", "has a choice of a feature")};

    std::uint32_t feature = 0;

    static constexpr auto fields()
    {
        return std::tuple(field(&HasFeature::feature, rulefields::feature({.doc = "its id"})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<HasFeature>{QT_TRANSLATE_NOOP("Rules", "“{feature}”"), nullptr,
                                               QT_TRANSLATE_NOOP("Rules", "not “{feature}”")}};
    }
    friend bool operator==(const HasFeature&, const HasFeature&) = default;
};

} // namespace crowd::model::conditions
