// SPDX-License-Identifier: MIT
#include "render/passes/GhostPass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <epoxy/gl.h>

#include "model/bake/KeyframeTime.h"
#include "render/crowd/CrowdView.h"

namespace crowd::render {

namespace {

using namespace model;

} // namespace

void GhostPass::initialize()
{
    m_rows.begin();
    m_instances = GlBuffer::create();
}

Result<void> GhostPass::draw(const PassContext& context, CrowdGpu& crowd)
{
    for (const Ghost& ghost : context.input.ghosts) {
        if (ghost.asset && !ghost.asset->levels.empty()) {
            if (auto drawn = drawGhost(context, crowd, ghost); !drawn) {
                return drawn;
            }
        }
    }
    glDisable(GL_BLEND);
    return {};
}

/// As it stands now.
const TemplateGpu& GhostPass::send(const PassContext& context, CrowdGpu& crowd, const Ghost& ghost)
{
    const int clipIndex =
        std::clamp(ghost.clip, 0, static_cast<int>(ghost.asset->clips.size()) - 1);
    TemplateGpu& gpu = crowd.gpuOf(ghost.asset);
    gpu.useClip(context.input.keyframes, clipIndex);
    const PlanClip& clip = gpu.clips()[static_cast<std::size_t>(clipIndex)];
    Instance instance;
    instance.boxes = clip.box | static_cast<std::uint32_t>(clip.box) << 16U;
    const KeyframePlace place =
        clip.isComplete ? keyframePlace(*clip.clip, ghost.phase) : KeyframePlace{};
    instance.keyframeA = clip.firstKeyframe + static_cast<std::uint32_t>(place.first);
    instance.keyframeB = clip.firstKeyframe + static_cast<std::uint32_t>(place.second);
    instance.blend = place.blend;
    context.statistics.areKeyframesMissing |= !clip.isComplete;
    const std::array<PlacementRecord, 1> placement{
        {{ghost.position + glm::vec3(0.0F, ghost.lift, 0.0F), std::cos(ghost.headingRadians),
          std::sin(ghost.headingRadians), ghost.height, ghost.girth, ghost.lift}}};
    const std::array<AppearanceRecord, 1> appearance{
        {{ghost.tints, ghost.materialChoices, ghost.parts, 0}}};
    m_rows.placement.write(0, std::as_bytes(std::span(placement)));
    m_rows.appearance.write(0, std::as_bytes(std::span(appearance)));
    sendInstances(m_instances, {&instance, 1});
    return gpu;
}

/// First its depth alone, so that only its front shows through.
Result<void> GhostPass::drawGhost(const PassContext& context, CrowdGpu& crowd, const Ghost& ghost)
{
    const TemplateGpu& gpu = send(context, crowd, ghost);
    const InstanceRun run{0, 0, 0, 1};
    PeopleDrawing::CrowdDraw drawing{m_rows, m_instances, context.style.materialDefines()};
    if (ghost.alpha < 1.0F) {
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        auto drawn = m_drawing.draw(context, drawing, gpu, run);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        if (!drawn) {
            return drawn;
        }
        drawing.defines += "OPACITY ";
        drawing.opacity = ghost.alpha;
    }
    if (auto drawn = m_drawing.draw(context, drawing, gpu, run); !drawn) {
        return drawn;
    }
    drawing.surface = Surface::SeeThrough;
    glDepthMask(GL_FALSE);
    auto drawn = m_drawing.draw(context, drawing, gpu, run);
    glDepthMask(GL_TRUE);
    return drawn;
}

} // namespace crowd::render
