// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct GoOn
{
    static constexpr KindText kText{.key = "go on",
                                    .name = QT_TRANSLATE_NOOP("Rules", "walk on"),
                                    .doc = "Walks on along what he walked before he stopped."};

    static constexpr auto fields() { return std::tuple(); }
    static constexpr auto sentences()
    {
        return std::array{Sentence<GoOn>{QT_TRANSLATE_NOOP("Rules", "walk on")}};
    }
    friend bool operator==(const GoOn&, const GoOn&) = default;
};

} // namespace crowd::model::actions
