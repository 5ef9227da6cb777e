// SPDX-License-Identifier: MIT
#include "render/passes/OutlinePass.h"

#include <algorithm>
#include <cmath>

#include <epoxy/gl.h>

namespace crowd::render {

namespace {

/// Arms and jumps reach out of a template's bounds: so many times its size.
constexpr float kReachOfClips = 1.5F;

/// A part of the picture, physical pixels from below left.
struct PixelRect
{
    glm::ivec2 low{0};
    glm::ivec2 high{0}; ///< not in it any more
    [[nodiscard]] bool isEmpty() const { return low.x >= high.x || low.y >= high.y; }
};

/// What highlighted people cover, generously.
PixelRect highlightedPart(const PassContext& context, const CrowdGpu& crowd, const CrowdPlan& plan)
{
    constexpr float kRim = 4.0F;
    const model::View& view = context.input.view;
    const glm::vec2 size(context.pixelSize);
    const float ratio = size.y / view.size().y;
    glm::vec2 low = size;
    glm::vec2 high(0.0F);
    for (const InstanceRun& run : plan.highlightedRuns()) {
        const model::Bounds& box = crowd.asset(run.entry)->bounds;
        const float far = glm::length(glm::max(glm::abs(box.low), glm::abs(box.high)));
        for (const Instance& instance : plan.highlighted().subspan(run.first, run.count)) {
            const PlacementRecord& place =
                crowd.records().placements()[instance.rowAndFlags & Instance::kRowMask];
            const float reach = far * kReachOfClips * std::max(place.height, place.girth);
            const auto foot = view.project(place.position);
            if (!foot || foot->z <= reach) {
                return {{0, 0}, context.pixelSize};
            }
            const glm::vec2 middle(foot->x * ratio, size.y - foot->y * ratio);
            const float pixels = (reach * view.pixelsPerMetre(foot->z - reach) + kRim) * ratio;
            low = glm::min(low, middle - pixels);
            high = glm::max(high, middle + pixels);
        }
    }
    return {glm::ivec2(glm::max(glm::floor(low), 0.0F)),
            glm::ivec2(glm::min(glm::ceil(high), size))};
}

} // namespace

model::Result<void> OutlinePass::initialize()
{
    auto program = ShaderProgram::build("outline");
    if (!program) {
        return program.error();
    }
    m_program = std::move(program).value();
    m_nothing = GlVertexArray::create();
    return {};
}

void OutlinePass::draw(const PassContext& context, std::uint32_t picture, const CrowdGpu& crowd,
                       const CrowdPlan& plan)
{
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const PixelRect part = highlightedPart(context, crowd, plan);
    if (part.isEmpty()) {
        return;
    }
    const float ratio =
        static_cast<float>(context.pixelSize.y) / std::max(1.0F, context.input.view.size().y);
    m_program.use();
    m_program.set("picture", 0);
    m_program.set("reach", std::max(1.0F, std::round(context.style.outlinePixels * ratio)));
    m_program.set("selectionColor", context.style.selectionColor);
    m_program.set("hoverColor", context.style.hoverColor);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture);
    glBindVertexArray(m_nothing.name());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.low.x, part.low.y, part.high.x - part.low.x, part.high.y - part.low.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glBindTexture(GL_TEXTURE_2D, 0);
    context.countDraw(1);
}

} // namespace crowd::render
