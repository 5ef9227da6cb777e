// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "behavior/agents/TemplateTables.h"
#include "behavior/motion/PathFollower.h"
#include "model/population/Population.h"

namespace crowd::behavior {

/// How people walk as the scene says: their pace, their path, and where beside others of their
/// group. Everything is drawn from the seed and the individual's id, so that it stays the same when
/// others come and go. Refers to the templates.
class Walkers
{
public:
    Walkers(const TemplateTables& templates, std::uint32_t seed)
        : m_templates(templates), m_seed(seed)
    {
    }
    /// By row, 0: nobody's; see Scene::parties().
    void setParties(std::vector<model::GroupId> partyOfRow);

    /// m/s.
    [[nodiscard]] float paceOf(const model::Population& people, std::size_t row) const;
    /// Of a row of the people that parties were set for. For PathFollower::follow(); path 0: it
    /// follows none.
    [[nodiscard]] PathFollower::Assignment assignmentOf(const model::Population& people,
                                                        std::size_t row) const;
    /// Along a path, chosen apart from the scene.
    [[nodiscard]] PathFollower::Assignment assignmentTo(model::IndividualId who, std::size_t row,
                                                        model::PathId path,
                                                        float metresPerSecond) const;

private:
    const TemplateTables& m_templates;
    std::uint32_t m_seed;
    std::vector<model::GroupId> m_parties; ///< by row
    std::map<model::GroupId, std::uint32_t> m_partySizes;
};

} // namespace crowd::behavior
