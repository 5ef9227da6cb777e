// SPDX-License-Identifier: MIT
#include "behavior/session/SessionTally.h"

#include "behavior/rules/PlaceRooms.h"
#include "behavior/session/Session.h"

namespace crowd::behavior {

SessionTally Session::tally() const
{
    SessionTally tally;
    std::vector<std::uint32_t> inside(m_places.size());
    for (std::uint32_t agent = 0; agent < agents(); ++agent) {
        if (isGone(agent)) {
            continue;
        }
        if (const model::PathId path = pathOf(agent); path != 0) {
            ++tally.followers[path];
        }
        const glm::vec3 at = position(agent);
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            inside[i] += flatDistance(m_places[i].position, at) <= m_places[i].radius ? 1U : 0U;
        }
    }
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        if (inside[i] > 0) {
            tally.inside[m_places[i].id] = inside[i];
        }
    }
    return tally;
}

} // namespace crowd::behavior
