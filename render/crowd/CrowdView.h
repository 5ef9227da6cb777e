// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "render/crowd/CrowdGpu.h"
#include "render/crowd/CrowdPlan.h"
#include "render/gl/GlObjects.h"

namespace crowd::render {

/// What is drawn of the crowd as somebody sees it, a camera or a light: who, at which level, in
/// which order; and that on the graphics card. Made once a frame from what CrowdGpu keeps; keeps
/// levels from frame to frame itself.
class CrowdView
{
public:
    struct Request
    {
        const model::CrowdFrame& frame;
        const model::View& view;
        float pixelRatio = 1.0F; ///< physical per logical pixel
        LevelThresholds levels;
        std::span<const model::IndividualId> selected{}; ///< ascending
        model::IndividualId hovered = 0;
    };

    void initialize();
    void plan(const Request& request, const CrowdGpu& crowd);
    void upload(const model::Camera& camera, CrowdGpu& crowd);
    /// Without an order of what is seen through.
    void uploadSolid();

    [[nodiscard]] std::span<const InstanceRun> runs() const { return m_plan.runs(); }
    [[nodiscard]] const GlBuffer& instances() const { return m_instances; }
    /// Those with something to see through, farthest first, across templates.
    [[nodiscard]] std::span<const InstanceRun> seeThroughRuns() const { return m_seeThroughRuns; }
    [[nodiscard]] const GlBuffer& seeThroughInstances() const { return m_seeThroughInstances; }
    [[nodiscard]] const CrowdPlan& planned() const { return m_plan; }

private:
    void collectSeeThrough(const model::Camera& camera, CrowdGpu& crowd);

    CrowdPlan m_plan;
    GlBuffer m_instances;
    std::vector<Instance> m_seeThrough;
    std::vector<InstanceRun> m_seeThroughRuns;
    GlBuffer m_seeThroughInstances;
};

/// Replaces what a buffer holds.
void sendInstances(GlBuffer& buffer, std::span<const Instance> instances);

} // namespace crowd::render
