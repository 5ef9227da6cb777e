// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "behavior/crowd/CrowdSimulation.h"
#include "behavior/session/SessionPose.h"
#include "model/base/Result.h"

/// Crowds to measure the simulation by: the same for everybody who compares.
namespace crowd::behavior {

/// Preferred speed of everybody in a workload, m/s.
inline constexpr float kWorkloadSpeed = 1.3F;
inline constexpr float kWorkloadStep = 1.0F / 30.0F;
inline constexpr float kWorkloadRadius = 0.25F;

/// A crowd with something to do. steer() says where everybody wants to go next; it is part of what
/// a step costs.
class Workload
{
public:
    virtual ~Workload() = default;

    virtual void steer() = 0;
    virtual void step()
    {
        steer();
        m_crowd.step(kWorkloadStep);
    }
    /// As a player keeps it after a step; null: no session.
    [[nodiscard]] virtual SessionPosePtr pose() const { return nullptr; }
    /// What a session of it runs; null: no session.
    [[nodiscard]] virtual const model::Scene* scene() const { return nullptr; }
    /// How many are outside the walls, where there are walls.
    [[nodiscard]] virtual std::size_t outsideWalls() const = 0;

    [[nodiscard]] virtual CrowdSimulation& crowd() { return m_crowd; }
    [[nodiscard]] const CrowdSimulation& crowd() const
    {
        return const_cast<Workload*>(this)->crowd();
    }

protected:
    Workload() = default;

    CrowdSimulation m_crowd;
};

/// "square": people at random, half a person per square metre, each with a random goal in the
/// square and a new one on arrival. "corridor": two directions in a corridor 10 m wide, two people
/// per square metre, turning round at the ends; its length follows the count. "city": four-way
/// streets between blocks of houses, half a person per square metre, everybody from crossing to
/// crossing. "paths": a session of people on wide cyclic paths in the open, half a person per
/// square metre, with gaits and the ready-made rules for pedestrians, and with a pose published
/// after every step.
[[nodiscard]] model::Result<std::unique_ptr<Workload>>
makeWorkload(std::string_view name, std::size_t count, std::uint64_t seed);

/// Random places in a rectangle, at least `apart` from each other (as far as they fit: later ones
/// come as close as they must), `margin` from its sides.
[[nodiscard]] std::vector<glm::vec2> scatter(std::size_t count, glm::vec2 low, glm::vec2 high,
                                             float apart, std::uint64_t seed);

/// The four sides of a rectangle.
[[nodiscard]] std::vector<Wall> rectangleWalls(glm::vec2 low, glm::vec2 high);

} // namespace crowd::behavior
