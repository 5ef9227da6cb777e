// SPDX-License-Identifier: MIT
#include "behavior/rules/ControlFlow.h"

#include <algorithm>

namespace crowd::behavior {

namespace {

/// Whether what belongs to a Repeat comes once more.
bool repeats(AgentRuleState& agent, const model::actions::Repeat& repeat, std::size_t line)
{
    const auto loop = std::ranges::find(agent.loops, line, &LoopFrame::line);
    if (loop == agent.loops.end()) {
        return false;
    }
    ++agent.branches;
    if (repeat.times != 0 && --loop->left == 0) {
        agent.loops.erase(loop, agent.loops.end());
        return false;
    }
    return true;
}

} // namespace

void enterLoop(AgentRuleState& agent, const model::Actions& actions, std::uint32_t times)
{
    const std::uint32_t line = agent.line;
    std::erase_if(agent.loops, [line](const LoopFrame& loop) { return loop.line >= line; });
    if (model::endOf(actions, line) == line + 1) {
        agent.line = lineAfter(agent, actions, line); // there is nothing in it
    } else {
        agent.loops.push_back({line, times});
        ++agent.line;
    }
}

std::uint32_t lineAfter(AgentRuleState& agent, const model::Actions& actions, std::size_t line)
{
    std::size_t next = model::endOf(actions, line);
    for (std::size_t parent = model::parentOf(actions, line);
         parent != model::kNoLine && next >= model::endOf(actions, parent);
         parent = model::parentOf(actions, parent)) {
        const auto* repeat = actions[parent].as<model::actions::Repeat>();
        if (repeat == nullptr) {
            next = model::endOf(actions, model::alternativesOf(actions, parent).back());
        } else if (repeats(agent, *repeat, parent)) {
            return static_cast<std::uint32_t>(parent + 1);
        }
    }
    return static_cast<std::uint32_t>(next);
}

} // namespace crowd::behavior
