// SPDX-License-Identifier: MIT
#include "behavior/motion/WalkParties.h"

#include <algorithm>
#include <cmath>

#include <glm/gtx/norm.hpp>

namespace crowd::behavior {

namespace {

constexpr float kPartyEase = 0.6F;      ///< metres from the middle that nobody minds
constexpr float kPartyFarthest = 25.0F; ///< metres: who is further away is alone
constexpr float kPartyHaste = 0.3F;     ///< share of the speed, a metre
constexpr float kPartySlowest = 0.4F;
constexpr float kPartyFastest = 1.3F;
constexpr float kPartyPull = 0.3F;      ///< m/s sideways, a metre
constexpr float kPartyMostPull = 0.35F; ///< share of the speed

} // namespace

std::vector<std::uint32_t> WalkParties::setGroups(std::span<const std::uint32_t> groups)
{
    std::vector<std::uint32_t> present(groups.begin(), groups.end());
    std::ranges::sort(present);
    present.erase(std::unique(present.begin(), present.end()), present.end());
    std::erase(present, 0U);
    m_parties.assign(present.size(), {});
    std::vector<std::uint32_t> parties;
    parties.reserve(groups.size());
    for (const std::uint32_t group : groups) {
        const auto found = std::ranges::lower_bound(present, group);
        parties.push_back(group == 0 ? kNone : static_cast<std::uint32_t>(found - present.begin()));
    }
    return parties;
}

void WalkParties::beginStep()
{
    std::ranges::fill(m_parties, Party());
}

void WalkParties::add(std::uint32_t index, std::uint32_t route, const glm::vec2& at, float pace)
{
    Party& party = m_parties[index];
    party.route = party.members == 0 ? route : party.route;
    if (party.route == route) {
        ++party.members;
        party.middle += at;
        party.pace += pace;
    }
}

void WalkParties::endStep()
{
    for (Party& party : m_parties) {
        const float share = 1.0F / static_cast<float>(std::max(1U, party.members));
        party.middle *= share;
        party.pace *= share;
    }
}

const WalkParties::Party* WalkParties::find(std::uint32_t index, std::uint32_t route) const
{
    if (index == kNone || m_parties[index].members < 2 || m_parties[index].route != route) {
        return nullptr;
    }
    return &m_parties[index];
}

void WalkParties::keepTogether(const Party& party, const glm::vec2& at, const glm::vec2& ahead,
                               float& speed, glm::vec2& sideways)
{
    const glm::vec2 away = at - party.middle;
    if (glm::length2(away) > kPartyFarthest * kPartyFarthest) {
        return;
    }
    const float lead = away.x * ahead.x + away.y * ahead.y;
    const float beyond = lead - std::clamp(lead, -kPartyEase, kPartyEase);
    speed *= std::clamp(1.0F - kPartyHaste * beyond, kPartySlowest, kPartyFastest);
    const glm::vec2 across = away - ahead * lead;
    const float distance = std::sqrt(glm::length2(across));
    if (distance > kPartyEase) {
        const float pull = std::min(kPartyPull * (distance - kPartyEase), kPartyMostPull * speed);
        sideways = -across * (pull / distance);
    }
}

} // namespace crowd::behavior
