// SPDX-License-Identifier: MIT
#include "render/passes/InkPass.h"

#include <algorithm>
#include <cmath>

#include <epoxy/gl.h>

namespace crowd::render {

namespace {

/// One over the distance along the camera's axis is linear in the picture: of (1, x, y), pixels
/// from below on the left.
glm::vec3 groundPlane(const model::View& view, const glm::ivec2& size)
{
    constexpr float kGroundHeight = -0.005F; // as in ground.vert
    const model::Camera& camera = view.camera();
    const float above = camera.position.y - kGroundHeight;
    if (above <= 0.0F) {
        return glm::vec3(0.0F);
    }
    const float ratio = static_cast<float>(size.y) / view.size().y;
    const float pixel = 1.0F / (view.pixelsPerMetre(1.0F) * ratio);
    const glm::vec2 middle = glm::vec2(size) * 0.5F * (1.0F + axisOf(view));
    const float aside = camera.right().y * pixel;
    const float up = camera.up().y * pixel;
    const float first = camera.forward().y - aside * middle.x - up * middle.y;
    return -glm::vec3(first, aside, up) / above;
}

} // namespace

void InkPass::initialize()
{
    m_nothing = GlVertexArray::create();
}

model::Result<void> InkPass::draw(const PassContext& context, const DepthCopy& depths)
{
    auto built = m_programs.get("");
    if (!built) {
        return built.error();
    }
    ShaderProgram& program = *built.value();
    const model::View& view = context.input.view;
    const float ratio = static_cast<float>(depths.size().y) / view.size().y;
    const bool isPerspective = view.camera().projection == model::Projection::Perspective;
    program.use();
    program.set("depths", 0);
    program.set("last", depths.size() - 1);
    program.set("width",
                std::max(1, static_cast<int>(std::lround(context.style.inkPixels * ratio * 0.5F))));
    program.set("unproject", unprojectOf(view));
    program.set("isPerspective", isPerspective ? 1 : 0);
    program.set("pixelsPerMetre", view.pixelsPerMetre(1.0F) * ratio);
    program.set("inkColor", context.style.inkColor);
    program.set("groundPlane",
                context.input.showGround ? groundPlane(view, depths.size()) : glm::vec3(0.0F));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, depths.texture().name());
    glBindVertexArray(m_nothing.name());
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    context.countDraw(1);
    return {};
}

} // namespace crowd::render
