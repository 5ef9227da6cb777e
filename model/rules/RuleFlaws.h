// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/scene/Scene.h"

/// What is wrong with rules as they stand, whoever they meet.
namespace crowd::model {

/// What is still to be chosen before a rule does anything.
enum class RuleGap : std::uint8_t {
    Event,        ///< that it waits for
    SentEvent,    ///< of "send an event"
    AwaitedEvent, ///< of "wait for an event"
    Clip,
    Place,
    Path,
    Number,
    Template,
    State,
    Light,
    Feature,
    Deed ///< there is nothing to do
};

enum class RuleFlawKind : std::uint8_t {
    Unfinished, ///< see `gap`: it does nothing until that is chosen
    NeverTrue,  ///< its conditions exclude each other
    Hidden,     ///< `other` always comes first
    BrokenOff,  ///< `other` always breaks it off at once
    Undone,     ///< `other` does the opposite at the same occasion
    NoSeats,    ///< it lets people sit where there are no seats
    NoExit,     ///< it lets people leave at an exit where there is none
    NoSender,   ///< it is about whoever it came from, and comes from nobody
    NoPayload,  ///< it asks for the number of an event where there is none
    AfterAgain  ///< lines after the one that begins anew
};

struct RuleFlaw
{
    RuleId rule = 0;
    RuleFlawKind kind = RuleFlawKind::Unfinished;
    RuleGap gap = RuleGap::Deed;
    RuleId other = 0;
    friend bool operator==(const RuleFlaw&, const RuleFlaw&) = default;
};

/// Nothing: it can act.
[[nodiscard]] std::optional<RuleGap> gapOf(const Rule& rule);
/// Of rules that are enabled, in their order.
[[nodiscard]] std::vector<RuleFlaw> flawsOf(const Scene& scene);
/// For scripts and the command line: a sentence that begins with the rule's name.
[[nodiscard]] std::string englishOf(const RuleFlaw& flaw, const Scene& scene);

} // namespace crowd::model
