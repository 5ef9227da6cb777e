// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "behavior/crowd/CrowdSimulation.h"
#include "model/scene/Path.h"

namespace crowd::behavior {

/// Sends agents along paths: each to its own point within every place's radius, the same share of
/// the radius to the same side everywhere, so that between two places a flow is as wide as their
/// radii say. Not thread safe; steer() itself uses all cores.
class PathFollower
{
public:
    /// Who walks where. `agent` names a row's agent, `seed` chooses the point within the radii.
    struct Assignment
    {
        std::uint32_t agent = 0;
        model::PathId path = 0;
        std::uint64_t seed = 0;
    };

    /// Sentences for the artist about paths and assignments that cannot be walked; those are left
    /// out.
    [[nodiscard]] std::vector<std::string> setPaths(std::span<const model::Place> places,
                                                    std::span<const model::Path> paths);
    [[nodiscard]] std::vector<std::string> assign(std::span<const Assignment> assignments,
                                                  std::size_t agents);

    /// Sets desired velocities, and places of those who jump to the first place.
    void steer(CrowdSimulation& crowd);

    [[nodiscard]] bool isWalking(std::uint32_t agent) const;
    /// Index in its path of the place that an agent goes to next.
    [[nodiscard]] std::size_t nextPlace(std::uint32_t agent) const { return m_walks[agent].next; }
    /// Whether its path has ended.
    [[nodiscard]] bool hasArrived(std::uint32_t agent) const { return m_walks[agent].hasArrived; }

private:
    struct Stop
    {
        glm::vec2 position{0.0F};
        float height = 0.0F;
        float radius = 0.0F;
    };
    struct Route
    {
        model::PathId id = 0;
        model::PathKind kind = model::PathKind::Simple;
        std::vector<Stop> stops;
    };
    struct Walk
    {
        std::uint32_t route = kNoRoute;
        std::uint32_t next = 0;
        glm::vec2 share{0.0F}; ///< of the radius, in the unit disk
        bool hasArrived = false;
    };
    static constexpr std::uint32_t kNoRoute = 0xFFFFFFFFU;

    [[nodiscard]] static glm::vec2 aim(const Walk& walk, const Stop& stop)
    {
        return stop.position + walk.share * stop.radius;
    }
    void goOn(AgentColumns& agents, std::size_t row, Walk& walk) const;

    std::vector<Route> m_routes;
    std::vector<Walk> m_walks; ///< by agent
};

} // namespace crowd::behavior
