// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct Wait
{
    static constexpr KindText kText{.key = "wait",
                                    .name = QT_TRANSLATE_NOOP("Rules", "wait"),
                                    .doc = "Waits so long, half of that more or less.",
                                    .beginsGroup = true};

    float seconds = 3.0F; ///< ± half of that

    static constexpr auto fields()
    {
        return std::tuple(
            field(&Wait::seconds, rulefields::seconds({.label = QT_TRANSLATE_NOOP("Rules", "about"),
                                                       .doc = "about how long"})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<Wait>{QT_TRANSLATE_NOOP("Rules", "wait about {seconds} s")}};
    }
    friend bool operator==(const Wait&, const Wait&) = default;
};

} // namespace crowd::model::actions
