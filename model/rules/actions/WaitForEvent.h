// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::actions {

struct WaitForEvent
{
    static constexpr KindText kText{.key = "wait for event",
                                    .name = QT_TRANSLATE_NOOP("Rules", "wait for an event"),
                                    .doc = "Waits until an event reaches him."};

    std::string event;
    float seconds = 3.0F; ///< at most; 0: for ever

    static constexpr auto fields()
    {
        return std::tuple(
            field(&WaitForEvent::event, rulefields::event({.doc = "its name"})),
            field(&WaitForEvent::seconds,
                  rulefields::seconds({.label = QT_TRANSLATE_NOOP("Rules", "at most"),
                                       .doc = "at most; 0: for ever",
                                       .zero = QT_TRANSLATE_NOOP("Rules", "for ever")})));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<WaitForEvent>{
                              QT_TRANSLATE_NOOP("Rules", "wait for “{event}”, at most {seconds} s"),
                              [](const WaitForEvent& s) { return s.seconds > 0.0F; }},
                          Sentence<WaitForEvent>{QT_TRANSLATE_NOOP("Rules", "wait for “{event}”")}};
    }
    void suit() { seconds = 0.0F; }
    friend bool operator==(const WaitForEvent&, const WaitForEvent&) = default;
};

} // namespace crowd::model::actions
