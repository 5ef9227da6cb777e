// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::triggers {

struct Event
{
    static constexpr KindText kText{.key = "event",
                                    .name = QT_TRANSLATE_NOOP("Rules", "an event comes"),
                                    .doc = "An event of that name reaches somebody."};

    std::string event;

    static constexpr auto fields()
    {
        return std::tuple(field(&Event::event, rulefields::event({.doc = "its name"})));
    }
    static constexpr auto sentences()
    {
        return std::array{
            Sentence<Event>{QT_TRANSLATE_NOOP("Rules", "When “{event}” reaches someone")}};
    }
    friend bool operator==(const Event&, const Event&) = default;
};

} // namespace crowd::model::triggers
