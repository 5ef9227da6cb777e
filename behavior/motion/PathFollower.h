// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "behavior/base/Agents.h"
#include "behavior/base/Problem.h"
#include "behavior/crowd/CrowdSimulation.h"
#include "behavior/motion/PathRoutes.h"
#include "behavior/motion/StrideKernel.h"
#include "behavior/motion/TravelEvents.h"
#include "behavior/motion/WalkParties.h"
#include "behavior/motion/WayAround.h"
#include "behavior/surface/WalkSurface.h"
#include "model/scene/Path.h"

namespace crowd::behavior {

/// Sends agents along paths: each to its own point within every place's radius, the same share of
/// the radius to the same side everywhere, so that between two places a flow is as wide as their
/// radii say. With a surface to walk on they go around what stands in the way. Not thread safe;
/// steer() itself uses all cores.
class PathFollower
{
public:
    /// Who walks where. `agent` names a row's agent, `seed` chooses the point within the radii.
    struct Assignment
    {
        std::uint32_t agent = 0;
        model::PathId path = 0;
        std::uint64_t seed = 0;
        float metresPerSecond = model::kUsualWalkingSpeed;
        std::uint64_t ownSeed = 0; ///< chooses where beside the point, for those who share one
        float spread = 0.0F;       ///< so far beside it at most, metres
        glm::vec3 from{0.0F};      ///< where the agent stands, world frame
    };

    /// Sentences for the artist about paths and assignments that cannot be walked; those are left
    /// out. Who walks goes on where the new paths allow.
    [[nodiscard]] std::vector<Problem> setPaths(std::span<const model::Place> places,
                                                std::span<const model::Path> paths);
    [[nodiscard]] std::vector<Problem> assign(std::span<const Assignment> assignments,
                                              std::size_t agents);
    /// What there is to walk on; null: open ground.
    void setSurface(std::shared_ptr<const WalkSurface> surface);

    /// Whom each agent keeps together with on a path; 0: nobody. Who is ahead waits a little, who
    /// is behind hurries, and all walk at the mean of their paces.
    void setGroups(std::span<const std::uint32_t> groupOfAgent);

    /// Joins the path where it is nearest, and goes on along it. False: there is no such path, and
    /// the agent stands.
    bool follow(const Assignment& assignment);
    [[nodiscard]] bool hasPath(model::PathId path) const
    {
        return m_routes.indexOf(path) != PathRoutes::kNone;
    }
    /// To a point, before anything else; stays there until told to go on. At his own pace, or at
    /// `atLeast` (m/s) where that is faster.
    void sendTo(std::uint32_t agent, const glm::vec3& point, float atLeast);
    void stop(std::uint32_t agent) { markDirty(agent).isHeld = true; }
    void goOn(std::uint32_t agent);
    /// He is somewhere else now: the way is looked for anew.
    void forgetWay(std::uint32_t agent);
    void setPace(std::uint32_t agent, float metresPerSecond);
    [[nodiscard]] float pace(std::uint32_t agent) const { return m_walks[agent].pace; }
    /// Agents are other ones now: keep[i] is the former agent, or kNoAgent for a new one.
    void rearrange(std::span<const std::uint32_t> keep);

    /// Sets desired velocities and preferred speeds, and places of those who jump to the first
    /// place.
    void steer(CrowdSimulation& crowd);

    [[nodiscard]] bool isWalking(std::uint32_t agent) const;
    /// Where somebody who walks goes straight to: the next corner of his way, or its end. World
    /// frame from above, metres.
    [[nodiscard]] glm::vec2 nextAim(std::uint32_t agent) const;
    /// Whether its path has ended.
    [[nodiscard]] bool hasArrived(std::uint32_t agent) const { return m_walks[agent].hasArrived; }
    /// TravelEvent bits of the last steer(), by agent.
    [[nodiscard]] std::span<const std::uint8_t> travelEvents() const { return m_events; }
    /// Of a path's stop that was reached last.
    [[nodiscard]] model::PlaceId reachedPlace(std::uint32_t agent) const
    {
        return m_walks[agent].reached;
    }
    [[nodiscard]] model::PathId pathOf(std::uint32_t agent) const;
    /// Where those who have walked a simple path to its end stand; 0: he has not.
    [[nodiscard]] model::PlaceId endPlace(std::uint32_t agent) const;

private:
    struct PlacePoint
    {
        glm::vec3 position{0.0F};
        bool isOnSurface = false;
    };
    struct Walk
    {
        std::uint32_t route = PathRoutes::kNone;
        std::uint32_t next = 0; ///< stop
        glm::vec2 share{0.0F};  ///< of the radius, in the unit disk
        glm::vec2 beside{0.0F}; ///< metres
        /// Its own in the place where it is going to, once asked for; metres.
        std::optional<PlacePoint> point;
        std::uint32_t party = WalkParties::kNone;
        std::uint64_t seed = 0;
        std::uint32_t turns = 0; ///< stops passed: keys the choice at a branch
        float pace = model::kUsualWalkingSpeed;
        bool hasArrived = false;
        bool isHeld = false;
        bool hasErrand = false;
        bool isErrandDone = false;
        glm::vec3 errand{0.0F};
        float errandPace = 0.0F; ///< m/s at least
        model::PlaceId reached = 0;
        WayAround way;
    };

    [[nodiscard]] static glm::vec2 aim(const Walk& walk, const RouteStop& stop)
    {
        return stop.position + walk.share * stop.radius + walk.beside;
    }
    /// The next step steers the agent in full.
    Walk& markDirty(std::uint32_t agent);
    void markAllDirty();
    void carryOver(Walk& walk, const PathRoutes& former) const;
    /// Returns TravelEvent bits.
    [[nodiscard]] std::uint8_t passStop(Body& body, float& height, Walk& walk) const;
    void branchOff(Walk& walk) const;
    void gatherParties(std::span<const Body> bodies);
    [[nodiscard]] const WalkParties::Party* partyOf(const Walk& walk) const;
    [[nodiscard]] PlacePoint pointIn(const Walk& walk, const RouteStop& stop) const;
    [[nodiscard]] glm::vec3 targetOf(Walk& walk) const;
    [[nodiscard]] Lane laneOf(const Walk& walk) const;
    [[nodiscard]] glm::vec2 wayTo(const Body& body, float height, Walk& walk,
                                  const glm::vec3& to) const;
    [[nodiscard]] float brakingMetres(const Walk& walk, const Body& body) const;
    [[nodiscard]] float slowness(float x, float z) const;
    [[nodiscard]] bool hasReached(const Walk& walk, const Body& body, float height,
                                  const glm::vec3& target) const;
    void steerAgent(std::uint32_t agent, Body& body, float& height);
    [[nodiscard]] glm::vec2 backToPath(const Walk& walk, const Body& body, float speed) const;
    void setVelocity(Walk& walk, Body& body, float height) const;
    void setAim(std::uint32_t agent);
    /// Alone, m/s.
    [[nodiscard]] static float paceOf(const Walk& walk)
    {
        return walk.hasErrand ? std::max(walk.pace, walk.errandPace) : walk.pace;
    }

    PathRoutes m_routes;
    WalkParties m_parties;
    std::vector<SlowArea> m_slow;
    std::vector<Walk> m_walks;          ///< by agent
    std::vector<std::uint8_t> m_events; ///< TravelEvent bits, by agent
    Aims m_aims;                        ///< of those who go straight on, by agent
    std::shared_ptr<const WalkSurface> m_surface;
};

} // namespace crowd::behavior
