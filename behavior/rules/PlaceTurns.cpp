// SPDX-License-Identifier: MIT
#include "behavior/rules/PlaceTurns.h"

namespace crowd::behavior {

PlaceTurns::Key PlaceTurns::keyOf(const PlaceWish& wish)
{
    return {wish.place, wish.path, wish.role == model::PlaceRole::Exit ? 1U : 0U};
}

bool PlaceTurns::isWaiting(const AgentStates& agents, const Turn& turn)
{
    const std::uint32_t agent = agents.agentNamed(turn.id);
    return agent != kNoAgent && agents[agent].rule != kNoRule &&
           agents[agent].progress.ticket == turn.ticket;
}

bool PlaceTurns::isFirst(const AgentStates& agents, std::uint32_t agent, const PlaceWish& wish)
{
    const auto found = m_turns.find(keyOf(wish));
    if (found == m_turns.end()) {
        return true;
    }
    std::deque<Turn>& turns = found->second;
    while (!turns.empty() && !isWaiting(agents, turns.front())) {
        turns.pop_front();
    }
    return turns.empty() || turns.front().id == agents.ids()[agent];
}

std::uint64_t PlaceTurns::append(model::IndividualId id, const PlaceWish& wish)
{
    m_turns[keyOf(wish)].push_back({++m_tickets, id});
    return m_tickets;
}

} // namespace crowd::behavior
