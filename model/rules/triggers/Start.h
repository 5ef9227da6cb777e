// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct Start
{
    static constexpr KindText kText{.key = "start",
                                    .name = QT_TRANSLATE_NOOP("Rules", "it begins"),
                                    .doc = "The session begins."};

    static constexpr auto fields() { return std::tuple(); }
    static constexpr auto sentences()
    {
        return std::array{Sentence<Start>{QT_TRANSLATE_NOOP("Rules", "When it begins")}};
    }
    friend bool operator==(const Start&, const Start&) = default;
};

} // namespace crowd::model::triggers
