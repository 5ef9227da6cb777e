// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct IsSeated
{
    static constexpr KindText kText{.key = "seated",
                                    .name = QT_TRANSLATE_NOOP("Rules", "seated"),
                                    .doc = "Sits on a seat.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "is"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "is not"),
                                    .alone = QT_TRANSLATE_NOOP("Rules", "is seated")};

    static constexpr auto fields() { return std::tuple(); }
    static constexpr auto sentences()
    {
        return std::array{Sentence<IsSeated>{QT_TRANSLATE_NOOP("Rules", "seated"), nullptr,
                                             QT_TRANSLATE_NOOP("Rules", "not seated")}};
    }
    friend bool operator==(const IsSeated&, const IsSeated&) = default;
};

} // namespace crowd::model::conditions
