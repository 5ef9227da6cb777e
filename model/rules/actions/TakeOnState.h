// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct TakeOnState
{
    static constexpr KindText kText{.key = "state",
                                    .name = QT_TRANSLATE_NOOP("Rules", "take on a state"),
                                    .doc = "Gets back what a kept state has of him, in this run "
                                           "alone."};

    std::uint32_t state = 0;
    float seconds = 0.0F; ///< that it takes
    float within = 0.0F;  ///< begins at a random moment within so many seconds

    static constexpr auto fields()
    {
        return std::tuple(
            field(&TakeOnState::state, rulefields::state({.doc = "its id"})),
            field(&TakeOnState::seconds,
                  rulefields::seconds({.label = QT_TRANSLATE_NOOP("Rules", "over"),
                                       .doc = "that it takes; 0: at once",
                                       .zero = QT_TRANSLATE_NOOP("Rules", "at once")})),
            field(&TakeOnState::within,
                  rulefields::seconds({.key = "within",
                                       .label = QT_TRANSLATE_NOOP("Rules", "beginning within"),
                                       .doc = "each begins at a moment of his own; 0: now",
                                       .zero = QT_TRANSLATE_NOOP("Rules", "now")})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<TakeOnState>{
                QT_TRANSLATE_NOOP("Rules", "take on “{state}”"),
                [](const TakeOnState& s) { return s.seconds <= 0.0F && s.within <= 0.0F; }},
            Sentence<TakeOnState>{QT_TRANSLATE_NOOP("Rules", "take on “{state}” within {within} s"),
                                  [](const TakeOnState& s) { return s.seconds <= 0.0F; }},
            Sentence<TakeOnState>{
                QT_TRANSLATE_NOOP("Rules", "take on “{state}” over {seconds} s")}};
    }
    friend bool operator==(const TakeOnState&, const TakeOnState&) = default;
};

} // namespace crowd::model::actions
