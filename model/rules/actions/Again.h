// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct Again
{
    static constexpr KindText kText{.key = "again",
                                    .name = QT_TRANSLATE_NOOP("Rules", "do it again"),
                                    .doc = "Begins with the first action again."};

    static constexpr auto fields() { return std::tuple(); }
    static constexpr auto sentences()
    {
        return std::array{Sentence<Again>{QT_TRANSLATE_NOOP("Rules", "do it again")}};
    }
    friend bool operator==(const Again&, const Again&) = default;
};

} // namespace crowd::model::actions
