// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "behavior/rules/RuleState.h"

/// What the kinds of actions have in common. Each has a function run(), called in each step while
/// the action is the one that its agent is at.
namespace crowd::behavior {

enum class ActionStatus : std::uint8_t {
    Running, ///< called again in the next step
    Done,    ///< on to the next line
    Jumped   ///< has said itself which line is the next
};

struct ActionScope : RuleScope
{
    std::uint32_t agent = 0;

    [[nodiscard]] AgentRuleState& self() const { return state.agents[agent]; }
    [[nodiscard]] ActionProgress& progress() const { return state.agents[agent].progress; }
    [[nodiscard]] double now() const { return state.clock.seconds; }
    [[nodiscard]] const std::vector<model::Action>& actions() const
    {
        return state.rules[self().rule].data.actions;
    }
    /// A message whose %1 is the name of the rule that runs.
    template<class... Arguments>
    void report(const char* id, const Arguments&... arguments) const
    {
        state.problems.add(problemOf(state, self().rule, id, arguments...));
    }
};

/// When an action of so many seconds is over; never where they are 0.
[[nodiscard]] double endAfter(const ActionScope& scope, float seconds);
/// One of the clips by weight; empty: there are none.
[[nodiscard]] std::string drawClip(const ActionScope& scope,
                                   const std::vector<model::ClipWeight>& clips);
void setTag(const ActionScope& scope, std::uint8_t tag, bool hasIt);
/// Becomes the value, or that much more.
void changeNumber(const ActionScope& scope, model::NumberId number, float value, bool isAdded);

} // namespace crowd::behavior
