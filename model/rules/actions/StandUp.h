// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct StandUp
{
    static constexpr KindText kText{.key = "stand up",
                                    .name = QT_TRANSLATE_NOOP("Rules", "stand up"),
                                    .doc = "Gets up from his seat."};

    static constexpr auto fields() { return std::tuple(); }
    static constexpr auto sentences()
    {
        return std::array{Sentence<StandUp>{QT_TRANSLATE_NOOP("Rules", "stand up")}};
    }
    friend bool operator==(const StandUp&, const StandUp&) = default;
};

} // namespace crowd::model::actions
