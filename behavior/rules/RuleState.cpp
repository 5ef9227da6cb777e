// SPDX-License-Identifier: MIT
#include "behavior/rules/RuleState.h"

#include "model/base/Random.h"

namespace crowd::behavior {

float draw(const RuleScope& scope, std::uint32_t agent, std::uint64_t purpose)
{
    const RuleState& state = scope.state;
    return model::unitFloat(model::hashKeys(state.seed, scope.host.id(agent), purpose,
                                            state.agents[agent].firings, state.clock.step));
}

void reportOverload(RuleState& state, std::uint32_t rule)
{
    if (!state.problems.noteOverload()) {
        return;
    }
    state.problems.add(
        {QT_TRANSLATE_NOOP(
             "Messages",
             "There is more for rules to do at once than a step has room for; characters act "
             "later, and events beyond half a million are dropped. Let rules send events to "
             "fewer characters, wait in between, or come less often."),
         rule == kNoRule ? 0 : state.rules[rule].data.id});
}

PlaceRooms& countedPlaces(const RuleScope& scope)
{
    RuleState& state = scope.state;
    if (!state.places.isCounted()) {
        std::vector<PlaceRooms::Guest> guests;
        guests.reserve(state.agents.size());
        for (std::uint32_t agent = 0; agent < state.agents.size(); ++agent) {
            if (!scope.host.isGone(agent)) {
                guests.push_back({scope.host.position(agent), state.agents[agent].heldPlace});
            }
        }
        state.places.count(guests);
    }
    return state.places;
}

void holdPlace(RuleState& state, std::uint32_t agent, model::PlaceId place)
{
    AgentRuleState& self = state.agents[agent];
    if (state.places.isCounted()) {
        state.places.move(self.heldPlace, place);
    }
    self.heldPlace = place;
}

} // namespace crowd::behavior
