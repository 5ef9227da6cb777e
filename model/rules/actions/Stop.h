// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct Stop
{
    static constexpr KindText kText{
        .key = "stop", .name = QT_TRANSLATE_NOOP("Rules", "stop"), .doc = "Stands still."};

    static constexpr auto fields() { return std::tuple(); }
    static constexpr auto sentences()
    {
        return std::array{Sentence<Stop>{QT_TRANSLATE_NOOP("Rules", "stop")}};
    }
    friend bool operator==(const Stop&, const Stop&) = default;
};

} // namespace crowd::model::actions
