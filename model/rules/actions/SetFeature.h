// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct SetFeature
{
    static constexpr KindText kText{.key = "feature",
                                    .name = QT_TRANSLATE_NOOP("Rules", "take on a feature"),
                                    .doc = "Bears a value of a feature from now on, with all that "
                                           "it does, in this run alone. Its clips play at once."};

    std::uint32_t feature = 0;

    static constexpr auto fields()
    {
        return std::tuple(field(&SetFeature::feature, rulefields::feature({.doc = "its id"})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<SetFeature>{QT_TRANSLATE_NOOP("Rules", "become “{feature}”")}};
    }
    friend bool operator==(const SetFeature&, const SetFeature&) = default;
};

} // namespace crowd::model::actions
