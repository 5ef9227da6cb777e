// SPDX-License-Identifier: MIT
#include "behavior/agents/Walkers.h"

#include <algorithm>
#include <cmath>

#include "model/base/Random.h"

namespace crowd::behavior {

namespace {

namespace walkerKeys = model::columns;

constexpr float kPersonReach = 0.25F; ///< metres
constexpr float kGroupSpread = 0.35F; ///< metres times the root of its size
constexpr float kLeastHeight = 0.05F;
// Purposes of draws.
constexpr std::uint64_t kPointInPlaces = 31;
constexpr std::uint64_t kPointInGroup = 32;
constexpr std::uint64_t kOwnPace = 33;
constexpr std::uint64_t kPointOfGroup = 34;

} // namespace

void Walkers::setParties(std::vector<model::GroupId> partyOfRow)
{
    m_parties = std::move(partyOfRow);
    m_partySizes.clear();
    for (const model::GroupId party : m_parties) {
        ++m_partySizes[party];
    }
}

float Walkers::paceOf(const model::Population& people, std::size_t row) const
{
    const float speed = people.column(walkerKeys::walkSpeed)[row];
    if (std::isfinite(speed) && speed > 0.0F) {
        return std::min(speed, model::kMaxWalkingSpeed);
    }
    const float usual =
        m_templates.usualSpeed(m_templates.indexOf(people.column(walkerKeys::templateId)[row]));
    const float height = std::max(people.column(walkerKeys::height)[row], kLeastHeight);
    const float u = model::unitFloat(model::hashKeys(m_seed, people.ids()[row], kOwnPace));
    return std::min(usual * height * (0.85F + 0.3F * u), model::kMaxWalkingSpeed);
}

PathFollower::Assignment Walkers::assignmentTo(model::IndividualId who, std::size_t row,
                                               model::PathId path, float metresPerSecond) const
{
    return {static_cast<std::uint32_t>(row), path, model::hashKeys(m_seed, who, kPointInPlaces),
            metresPerSecond};
}

PathFollower::Assignment Walkers::assignmentOf(const model::Population& people,
                                               std::size_t row) const
{
    const model::IndividualId who = people.ids()[row];
    PathFollower::Assignment walk =
        assignmentTo(who, row, people.column(walkerKeys::path)[row], paceOf(people, row));
    walk.ownSeed = model::hashKeys(m_seed, who, kPointInGroup);
    walk.from = people.column(walkerKeys::position)[row];
    const model::GroupId group = m_parties[row];
    const auto size = m_partySizes.find(group);
    if (group != 0 && size != m_partySizes.end() && size->second > 1) {
        // To the same point as the others, a little beside it.
        walk.seed = model::hashKeys(m_seed, group, kPointOfGroup);
        const std::uint32_t table = m_templates.indexOf(people.column(walkerKeys::templateId)[row]);
        const float reach = m_templates.has(table) ? m_templates.footprint(table).reach() : 0.0F;
        const float girth = people.column(walkerKeys::girth)[row];
        walk.spread = kGroupSpread * std::sqrt(static_cast<float>(size->second)) *
                      std::clamp(reach * girth / kPersonReach, 1.0F, 10.0F);
    }
    return walk;
}

} // namespace crowd::behavior
