// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct StateRecalled
{
    static constexpr KindText kText{.key = "state",
                                    .name = QT_TRANSLATE_NOOP("Rules", "a state is recalled"),
                                    .doc = "Somebody begins to take on a state, whoever recalled "
                                           "it."};

    std::uint32_t state = 0; ///< 0: any

    static constexpr auto fields()
    {
        return std::tuple(field(&StateRecalled::state,
                                rulefields::state({.doc = "its id; 0: any",
                                                   .zero = QT_TRANSLATE_NOOP("Rules", "any")})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<StateRecalled>{QT_TRANSLATE_NOOP("Rules", "When someone takes on a state"),
                                    [](const StateRecalled& s) { return s.state == 0; }},
            Sentence<StateRecalled>{QT_TRANSLATE_NOOP("Rules", "When someone takes on “{state}”")}};
    }
    friend bool operator==(const StateRecalled&, const StateRecalled&) = default;
};

} // namespace crowd::model::triggers
