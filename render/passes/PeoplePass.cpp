// SPDX-License-Identifier: MIT
#include "render/passes/PeoplePass.h"

#include <epoxy/gl.h>

namespace crowd::render {

using model::Result;

Result<void> PeoplePass::drawRuns(const PassContext& context, CrowdGpu& crowd,
                                  const GlBuffer& instances, std::span<const InstanceRun> runs,
                                  Surface surface)
{
    PeopleDrawing::CrowdDraw drawing{crowd.rows(), instances, context.style.materialDefines()};
    drawing.defines += crowd.records().replacesColours() ? "REPLACED " : "";
    drawing.surface = surface;
    Result<void> drawn;
    for (const InstanceRun& run : runs) {
        drawn = m_drawing.draw(context, drawing, crowd.gpuOf(run.entry), run);
        if (!drawn) {
            break;
        }
    }
    glDisable(GL_BLEND);
    return drawn;
}

Result<void> PeoplePass::draw(const PassContext& context, CrowdGpu& crowd, const CrowdView& view)
{
    return drawRuns(context, crowd, view.instances(), view.runs(), Surface::Solid);
}

/// They hide nothing of each other, so nothing of them is lost where they overlap.
Result<void> PeoplePass::drawSeeThrough(const PassContext& context, CrowdGpu& crowd,
                                        const CrowdView& view)
{
    if (view.seeThroughRuns().empty()) {
        return {};
    }
    glDepthMask(GL_FALSE);
    auto drawn = drawRuns(context, crowd, view.seeThroughInstances(), view.seeThroughRuns(),
                          Surface::SeeThrough);
    glDepthMask(GL_TRUE);
    return drawn;
}

} // namespace crowd::render
