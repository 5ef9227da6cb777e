// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct ClipEnded
{
    static constexpr KindText kText{.key = "clip ended",
                                    .name = QT_TRANSLATE_NOOP("Rules", "a clip is over"),
                                    .doc = "A clip that a rule let somebody play is over."};

    static constexpr auto fields() { return std::tuple(); }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<ClipEnded>{QT_TRANSLATE_NOOP("Rules", "When someone’s clip is over")}};
    }
    friend bool operator==(const ClipEnded&, const ClipEnded&) = default;
};

} // namespace crowd::model::triggers
