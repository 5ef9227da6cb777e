// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct Repeat
{
    static constexpr KindText kText{.key = "repeat",
                                    .name = QT_TRANSLATE_NOOP("Rules", "repeat"),
                                    .doc = "Does the deeper actions below it so many times.",
                                    .hasParts = true};

    std::uint32_t times = 2; ///< 0: for ever

    static constexpr auto fields()
    {
        return std::tuple(field(
            &Repeat::times, rulefields::numeric({.doc = "how often; 0: for ever",
                                                 .unit = QT_TRANSLATE_NOOP("Rules", " ×"),
                                                 .zero = QT_TRANSLATE_NOOP("Rules", "for ever")},
                                                "times", 0.0, kMaxTimes)));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Repeat>{QT_TRANSLATE_NOOP("Rules", "repeat for ever {inside}"),
                             [](const Repeat& s) { return s.times == 0; }},
            Sentence<Repeat>{QT_TRANSLATE_NOOP("Rules", "repeat {times} × {inside}")}};
    }
    void suit() { times = 2; }
    friend bool operator==(const Repeat&, const Repeat&) = default;
};

} // namespace crowd::model::actions
