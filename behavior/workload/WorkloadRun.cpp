// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "behavior/workload/Workload.h"

namespace crowd::behavior {

namespace {

constexpr float kOverlapMetres = 0.4F;
constexpr int kStepsASample = 10;

/// Watches a crowd from step to step.
class Watch
{
public:
    explicit Watch(const Workload& workload)
        : m_workload(workload), m_velocity(workload.crowd().size()),
          m_place(workload.crowd().size())
    {
        remember();
        std::ranges::fill(m_velocity, glm::dvec2(0.0)); // everybody starts at rest
    }

    void afterStep(int step)
    {
        measureMotion();
        remember();
        if (step % kStepsASample == 0) {
            sample();
        }
    }
    [[nodiscard]] WorkloadFigures figures() const
    {
        WorkloadFigures figures = m_figures;
        const auto motions = static_cast<double>(std::max<std::size_t>(m_motions, 1));
        figures.efficiency = m_progress / motions;
        figures.rmsAcceleration = std::sqrt(m_squares / motions);
        const auto people = static_cast<double>(m_workload.crowd().size());
        figures.bytesPerAgent = static_cast<double>(m_workload.crowd().bytes()) / people;
        return figures;
    }

private:
    void remember()
    {
        const AgentColumns& agents = m_workload.crowd().columns();
        for (std::size_t row = 0; row < agents.size(); ++row) {
            const glm::dvec2 place(agents.x[row], agents.z[row]);
            m_velocity[agents.agent[row]] =
                (place - m_place[agents.agent[row]]) / static_cast<double>(kWorkloadStep);
            m_place[agents.agent[row]] = place;
        }
    }
    void measureMotion()
    {
        const AgentColumns& agents = m_workload.crowd().columns();
        for (std::size_t row = 0; row < agents.size(); ++row) {
            const glm::dvec2 place(agents.x[row], agents.z[row]);
            const glm::dvec2 velocity =
                (place - m_place[agents.agent[row]]) / static_cast<double>(kWorkloadStep);
            const glm::dvec2 wish(agents.desiredX[row], agents.desiredZ[row]);
            const glm::dvec2 change = velocity - m_velocity[agents.agent[row]];
            const auto speed = static_cast<double>(agents.preferredSpeed[row]);
            m_progress += (velocity.x * wish.x + velocity.y * wish.y) / (speed * speed);
            m_squares += (change.x * change.x + change.y * change.y) /
                         (static_cast<double>(kWorkloadStep) * static_cast<double>(kWorkloadStep));
        }
        m_motions += agents.size();
    }
    void sample()
    {
        const AgentColumns& agents = m_workload.crowd().columns();
        const auto people = static_cast<double>(agents.size());
        const auto pairs =
            static_cast<double>(countPairsCloserThan(m_workload.crowd(), kOverlapMetres));
        m_figures.overlapsPer1000 = std::max(m_figures.overlapsPer1000, 1000.0 * pairs / people);
        m_figures.outsideWalls = std::max(m_figures.outsideWalls,
                                          static_cast<double>(m_workload.outsideWalls()) / people);
        for (std::size_t row = 0; row < agents.size(); ++row) {
            const float sum =
                agents.x[row] + agents.z[row] + agents.velocityX[row] + agents.velocityZ[row];
            m_figures.brokenNumbers += std::isfinite(sum) ? 0U : 1U;
        }
    }

    const Workload& m_workload;
    std::vector<glm::dvec2> m_velocity; ///< by agent; from places, so that no push goes unseen
    std::vector<glm::dvec2> m_place;
    double m_progress = 0.0;
    double m_squares = 0.0;
    std::size_t m_motions = 0;
    WorkloadFigures m_figures;
};

} // namespace

WorkloadFigures runWorkload(Workload& workload, int steps, double (*clockMs)())
{
    Watch watch(workload);
    std::vector<double> stepMs;
    for (int step = 1; step <= steps; ++step) {
        const double start = clockMs != nullptr ? clockMs() : 0.0;
        workload.step();
        if (clockMs != nullptr) {
            stepMs.push_back(clockMs() - start);
        }
        watch.afterStep(step);
    }
    WorkloadFigures figures = watch.figures();
    figures.stepMs = std::move(stepMs);
    return figures;
}

} // namespace crowd::behavior
