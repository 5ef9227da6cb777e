// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "behavior/crowd/AgentRows.h"

namespace crowd::behavior {

/// How much of an agent a step computes.
enum class UpdateMode : std::int32_t {
    Continue, ///< motion only, many at once, while the speed stays within the limits of the gait
    Rest,     ///< nothing, until it moves
    Full      ///< everything, one agent at a time: its state was written from outside
};

/// Position, heading, speed, and place in the clip shown of every agent: world frame, metres,
/// seconds, radians. One column each, so that the kernels read many agents at once; every column
/// has kLanes spare elements at its end, so that they may read whole blocks.
struct MotionState
{
    std::vector<std::int32_t> mode; ///< UpdateMode
    std::vector<float> x;           ///< where they are shown
    std::vector<float> y;
    std::vector<float> z;
    std::vector<float> heading;
    std::vector<float> speed;  ///< smoothed, m/s
    std::vector<float> stride; ///< m/s that they went ahead in the last step
    // Of the gait; without gaits it plays no part.
    std::vector<float> gaitPlace; ///< in its clip, 0..1
    std::vector<float> perMetre;  ///< playback speed for a speed of 1 m/s; 0: it is to stand with
    std::vector<float> perSecond; ///< of the clip, at playback speed 1; 0: it stays where it is
    std::vector<float> slowest;   ///< beyond these speeds it may be another one
    std::vector<float> fastest;
    std::vector<std::int32_t> isGaitShown; ///< -1: the clip shown is the gait's; 0: another one
    // The clip that is shown.
    std::vector<float> place; ///< in it; loops 0..1; at time 0 where it goes by the clock
    std::vector<float> rate;  ///< playback speed
    std::vector<float> clipSeconds;
    std::vector<std::uint16_t> clip;
    std::vector<std::uint8_t> flags; ///< PoseFlag

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] glm::vec3 position(std::size_t agent) const
    {
        return {x[agent], y[agent], z[agent]};
    }
    void put(std::size_t agent, const glm::vec3& position)
    {
        x[agent] = position.x;
        y[agent] = position.y;
        z[agent] = position.z;
    }

    /// So many, who have none yet.
    void assign(std::size_t agents)
    {
        m_size = agents;
        eachColumn([agents](auto& column) { column.assign(agents + kLanes, {}); });
    }
    /// Other agents: each was former[i], or is new where that is none of them.
    void rearrange(std::span<const std::uint32_t> former)
    {
        eachColumn([this, former](auto& column) {
            auto next = column;
            next.assign(former.size() + kLanes, {});
            for (std::size_t i = 0; i < former.size(); ++i) {
                next[i] = former[i] < m_size ? column[former[i]] : next[i];
            }
            column = std::move(next);
        });
        m_size = former.size();
    }

private:
    template<class Act>
    void eachColumn(const Act& act)
    {
        for (auto* column : {&x, &y, &z, &heading, &speed, &stride, &gaitPlace, &perMetre,
                             &perSecond, &slowest, &fastest, &place, &rate, &clipSeconds}) {
            act(*column);
        }
        act(mode);
        act(isGaitShown);
        act(clip);
        act(flags);
    }

    std::size_t m_size = 0;
};

} // namespace crowd::behavior
