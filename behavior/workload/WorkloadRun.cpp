// SPDX-License-Identifier: MIT
#include "behavior/workload/WorkloadRun.h"

#include <algorithm>
#include <cmath>

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
        figures.efficiency = m_progress / static_cast<double>(std::max<std::size_t>(m_walks, 1));
        figures.rmsAcceleration = std::sqrt(m_squares / motions);
        const auto people = static_cast<double>(m_workload.crowd().size());
        figures.bytesPerAgent = static_cast<double>(m_workload.crowd().bytes()) / people;
        return figures;
    }

private:
    void remember()
    {
        const std::span<const Body> bodies = m_workload.crowd().bodies();
        for (std::size_t agent = 0; agent < bodies.size(); ++agent) {
            const glm::dvec2 place(bodies[agent].x, bodies[agent].z);
            m_velocity[agent] = (place - m_place[agent]) / static_cast<double>(kWorkloadStep);
            m_place[agent] = place;
        }
    }
    void measureMotion()
    {
        const std::span<const Body> bodies = m_workload.crowd().bodies();
        for (std::size_t agent = 0; agent < bodies.size(); ++agent) {
            const Body& body = bodies[agent];
            const glm::dvec2 place(body.x, body.z);
            const glm::dvec2 velocity =
                (place - m_place[agent]) / static_cast<double>(kWorkloadStep);
            const glm::dvec2 wish(body.desiredX, body.desiredZ);
            const glm::dvec2 change = velocity - m_velocity[agent];
            const auto speed = static_cast<double>(body.preferredSpeed);
            if (speed > 0.0) { // who stands makes no progress and wants none
                m_progress += (velocity.x * wish.x + velocity.y * wish.y) / (speed * speed);
                ++m_walks;
            }
            m_squares += (change.x * change.x + change.y * change.y) /
                         (static_cast<double>(kWorkloadStep) * static_cast<double>(kWorkloadStep));
        }
        m_motions += bodies.size();
    }
    void sample()
    {
        const auto people = static_cast<double>(m_workload.crowd().size());
        const auto pairs =
            static_cast<double>(countPairsCloserThan(m_workload.crowd(), kOverlapMetres));
        m_figures.overlapsPer1000 = std::max(m_figures.overlapsPer1000, 1000.0 * pairs / people);
        m_figures.outsideWalls = std::max(m_figures.outsideWalls,
                                          static_cast<double>(m_workload.outsideWalls()) / people);
        for (const Body& body : m_workload.crowd().bodies()) {
            const float sum = body.x + body.z + body.velocityX + body.velocityZ;
            m_figures.brokenNumbers += std::isfinite(sum) ? 0U : 1U;
        }
    }

    const Workload& m_workload;
    std::vector<glm::dvec2> m_velocity; ///< by agent; from places, so that no push goes unseen
    std::vector<glm::dvec2> m_place;
    double m_progress = 0.0;
    double m_squares = 0.0;
    std::size_t m_motions = 0;
    std::size_t m_walks = 0;
    WorkloadFigures m_figures;
};

} // namespace

WorkloadFigures runWorkload(Workload& workload, int steps, double (*clockMs)(),
                            const std::function<void(int)>& beforeStep)
{
    Watch watch(workload);
    std::vector<double> stepMs;
    for (int step = 1; step <= steps; ++step) {
        if (beforeStep) {
            beforeStep(step - 1);
        }
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
