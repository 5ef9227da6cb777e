// SPDX-License-Identifier: MIT
#include "behavior/motion/WalkParties.h"

#include <algorithm>
#include <cmath>

#include <glm/gtx/norm.hpp>

#include "model/scene/Scene.h"

namespace crowd::behavior {

namespace {

constexpr float kPartyEase = 0.6F;      ///< metres from the middle that nobody minds
constexpr float kAbreast = 0.4F;        ///< metres from the middle, for each of the others
constexpr float kAbreastEase = 0.2F;    ///< metres
constexpr float kInLine = 0.25F;        ///< metres beside the middle
constexpr float kQueueEase = 0.35F;     ///< metres, for each member
constexpr float kPartyFarthest = 25.0F; ///< metres: who is further away is alone
constexpr float kPartyHaste = 0.3F;     ///< share of the speed, a metre
constexpr float kPartySlowest = 0.4F;
constexpr float kPartyFastest = 1.3F;
constexpr float kPartyPull = 0.3F;      ///< m/s sideways, a metre
constexpr float kPartyMostPull = 0.35F; ///< share of the speed

/// How far somebody may be before or behind the middle. Who are beside it keep level; who are in
/// line with it are where there is no room beside each other.
float leadOf(const WalkParties::Party& party, float beside)
{
    if (!party.isClose) {
        return kPartyEase;
    }
    return beside > kInLine ? kAbreastEase : kQueueEase * static_cast<float>(party.members);
}

} // namespace

std::vector<std::uint32_t> WalkParties::setGroups(std::span<const std::uint32_t> groups)
{
    std::vector<std::uint32_t> present(groups.begin(), groups.end());
    std::ranges::sort(present);
    present.erase(std::unique(present.begin(), present.end()), present.end());
    std::erase(present, 0U);
    m_parties.assign(present.size(), {});
    m_areClose.clear();
    for (const std::uint32_t group : present) {
        m_areClose.push_back(static_cast<char>(group >= model::kRelatedParty));
    }
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
    for (std::size_t i = 0; i < m_parties.size(); ++i) {
        m_parties[i] = Party();
        m_parties[i].isClose = m_areClose[i] != 0;
    }
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
    const glm::vec2 across = away - ahead * lead;
    const float distance = std::sqrt(glm::length2(across));
    const float leadEase = leadOf(party, distance);
    const float wide = party.isClose
                           ? kAbreast * static_cast<float>(party.members - 1) + kAbreastEase
                           : kPartyEase;
    const float beyond = lead - std::clamp(lead, -leadEase, leadEase);
    speed *= std::clamp(1.0F - kPartyHaste * beyond, kPartySlowest, kPartyFastest);
    if (distance > wide) {
        const float pull = std::min(kPartyPull * (distance - wide), kPartyMostPull * speed);
        sideways = -across * (pull / distance);
    }
}

} // namespace crowd::behavior
