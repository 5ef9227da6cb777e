// SPDX-License-Identifier: MIT
#include "render/passes/BackgroundPass.h"

#include <algorithm>

#include <epoxy/gl.h>

namespace crowd::render {

namespace {

constexpr float kHalfSize = 1500.0F; ///< metres
constexpr float kFadeNear = 120.0F;  ///< the plane is sky-coloured from here on, at least
constexpr float kFadePerHeight = 25.0F;

} // namespace

void BackgroundPass::initialize()
{
    m_nothing = GlVertexArray::create();
}

model::Result<void> BackgroundPass::drawGround(const PassContext& context)
{
    auto built =
        m_ground.get((context.style.hasGrid ? "GRID " : "") + context.style.surfaceDefines);
    if (!built) {
        return built.error();
    }
    ShaderProgram& program = *built.value();
    const glm::vec3 eye = context.input.view.camera().position;
    program.use();
    context.setCommon(program);
    program.set("center", glm::vec2(eye.x, eye.z));
    program.set("halfSize", kHalfSize);
    program.set("groundColor", context.style.groundColor);
    program.set("groundBase", context.style.light.ground);
    program.set("horizon", context.style.light.horizon);
    const float fade = std::max(kFadeNear, std::abs(eye.y) * kFadePerHeight);
    program.set("fadeDistance", std::min(fade, kHalfSize));
    glBindVertexArray(m_nothing.name());
    glDisable(GL_CULL_FACE);
    // A stage's floor at the same height wins.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0F, 8.0F);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_POLYGON_OFFSET_FILL);
    context.countDraw(2);
    return {};
}

model::Result<void> BackgroundPass::drawSky(const PassContext& context)
{
    auto built = m_sky.get(context.style.tone.defines());
    if (!built) {
        return built.error();
    }
    ShaderProgram& sky = *built.value();
    sky.use();
    sky.set("worldFromClip", glm::inverse(context.viewProjection));
    sky.set("zenith", context.style.light.zenith);
    sky.set("horizon", context.style.light.horizon);
    sky.set("toneGain", context.style.tone.gain);
    glBindVertexArray(m_nothing.name());
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthMask(GL_TRUE);
    context.countDraw(1);
    return {};
}

} // namespace crowd::render
