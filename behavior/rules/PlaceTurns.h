// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>

#include "behavior/rules/AgentStates.h"
#include "behavior/rules/PlaceRooms.h"

namespace crowd::behavior {

/// Who waits for a free place of the same choice: first come, first served. An agent's turn is the
/// ticket in its ActionProgress; whoever does something else than wait has lost it.
class PlaceTurns
{
public:
    /// Nobody waits for such a place for longer than he does.
    [[nodiscard]] bool isFirst(const AgentStates& agents, std::uint32_t agent,
                               const PlaceWish& wish);
    /// The last of those who wait for such a place gets a ticket.
    [[nodiscard]] std::uint64_t append(model::IndividualId id, const PlaceWish& wish);

private:
    struct Turn
    {
        std::uint64_t ticket = 0;
        model::IndividualId id = 0;
    };
    using Key = std::array<std::uint32_t, 3>; ///< place, path, whether they leave there

    [[nodiscard]] static Key keyOf(const PlaceWish& wish);
    [[nodiscard]] static bool isWaiting(const AgentStates& agents, const Turn& turn);

    std::map<Key, std::deque<Turn>> m_turns;
    std::uint64_t m_tickets = 0;
};

} // namespace crowd::behavior
