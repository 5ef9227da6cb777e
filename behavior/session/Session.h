// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "behavior/crowd/CrowdSimulation.h"
#include "behavior/session/Gait.h"
#include "behavior/session/PathFollower.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Path.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// What a session needs to know beside the scene.
struct SessionPlan
{
    struct Walker
    {
        model::IndividualId id = 0;
        model::PathId path = 0;
        float metresPerSecond = 1.3F;
    };
    std::vector<model::Place> places;
    std::vector<model::Path> paths;
    std::vector<Walker> walkers;
    std::vector<Wall> walls;
};

/// One run of the simulation. Starts from the scene, keeps columns of its own and never writes to
/// the scene. Whoever is not a walker is an obstacle that stays. Steps are 1/30 s; the same scene,
/// plan and number of steps give the same bits. One thread at a time; frames may be read on any.
class Session
{
public:
    static constexpr float kStepSeconds = 1.0F / 30.0F;

    Session(const model::Scene& scene, const SessionPlan& plan);

    void step();
    [[nodiscard]] std::uint64_t steps() const { return m_steps; }
    [[nodiscard]] double seconds() const { return static_cast<double>(m_steps) / 30.0; }
    /// Everybody as of the last step, for the renderer.
    [[nodiscard]] model::CrowdFramePtr frame();
    /// Sentences for the artist about what in the plan could not be followed.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return m_warnings; }

    /// For measuring and tuning.
    [[nodiscard]] CrowdSimulation& crowd() { return m_crowd; }
    [[nodiscard]] const PathFollower& follower() const { return m_follower; }

private:
    /// What a walker shows; one per walker, ascending by id.
    struct Shown
    {
        std::uint32_t row = 0; ///< in the population
        std::uint32_t table = 0;
        std::uint32_t gait = 0;
        float speed = 0.0F; ///< smoothed, m/s
        float heading = 0.0F;
        float height = 1.0F;
        double place = 0.0; ///< in the clip, 0..1
        glm::vec3 position{0.0F};
    };

    void addWalkers(const SessionPlan& plan);
    void addBodies(const SessionPlan& plan);
    void show(std::size_t row);

    model::Population m_population;
    std::shared_ptr<const std::vector<model::TemplateEntry>> m_templates;
    std::vector<GaitTable> m_gaits; ///< one per template
    std::vector<model::IndividualId> m_ids;
    std::vector<Shown> m_shown;
    std::vector<std::uint32_t> m_walkerOfAgent; ///< agents are rows of the population
    std::vector<float> m_wantedSpeed;           ///< by walker
    CrowdSimulation m_crowd;
    PathFollower m_follower;
    std::vector<std::string> m_warnings;
    std::uint32_t m_seed = 1;
    std::uint64_t m_steps = 0;
};

} // namespace crowd::behavior
