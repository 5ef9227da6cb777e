// SPDX-License-Identifier: MIT
#include "render/passes/OcclusionPass.h"

#include <epoxy/gl.h>

#include "render/gl/Blending.h"

namespace crowd::render {

namespace {

using model::Result;

constexpr float kRadius = 0.55F; ///< metres within which things hide the sky from each other

GlTexture makeTexture(glm::ivec2 size)
{
    GlTexture texture = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    if (texture.take(pixelBytes(size, 4))) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16, size.x, size.y, 0, GL_RG, GL_UNSIGNED_SHORT,
                     nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

bool isFrameComplete()
{
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

/// Without a GPU, while smooth edges are not wanted either.
bool isQuick(const PassContext& context)
{
    return context.isSoftware && context.input.samples == 0;
}

void drawTriangle(const PassContext& context)
{
    glDrawArrays(GL_TRIANGLES, 0, 3);
    context.countDraw(1);
}

void bindAt(GLenum unit, const GlTexture& texture)
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture.name());
}

} // namespace

glm::ivec2 OcclusionPass::coarseSize() const
{
    return (m_size + m_coarseness - 1) / m_coarseness;
}

void OcclusionPass::initialize()
{
    m_nothing = GlVertexArray::create();
}

bool OcclusionPass::make()
{
    bool isUsable = true;
    const glm::ivec2 coarse = coarseSize();
    for (std::size_t i = 0; i < 2; ++i) {
        m_found[i] = makeTexture(coarse);
        m_foundFrames[i] = GlFramebuffer::create();
        glBindFramebuffer(GL_FRAMEBUFFER, m_foundFrames[i].name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                               m_found[i].name(), 0);
        isUsable = isUsable && isFrameComplete();
    }
    return isUsable;
}

Result<void> OcclusionPass::find(const PassContext& context, const DepthCopy& depths)
{
    auto built = m_programs.get(isQuick(context) ? "QUICK" : "");
    if (!built) {
        return built.error();
    }
    ShaderProgram& program = *built.value();
    program.use();
    const model::View& view = context.input.view;
    const bool isPerspective = view.camera().projection == model::Projection::Perspective;
    const float ratio = static_cast<float>(m_size.y) / view.size().y;
    program.set("depths", 0);
    program.set("unproject", unprojectOf(view));
    program.set("axis", axisOf(view));
    program.set("isPerspective", isPerspective ? 1 : 0);
    program.set("coarseness", m_coarseness);
    program.set("radius", kRadius);
    program.set("pixelsPerMetre", view.pixelsPerMetre(1.0F) * ratio);
    program.set("texel", 1.0F / glm::vec2(m_size));
    program.set("last", m_size - 1);
    bindAt(0, depths.texture());
    glBindFramebuffer(GL_FRAMEBUFFER, m_foundFrames[0].name());
    const glm::ivec2 coarse = coarseSize();
    glViewport(0, 0, coarse.x, coarse.y);
    drawTriangle(context);
    return {};
}

Result<void> OcclusionPass::spread(const PassContext& context, std::size_t from, glm::ivec2 way)
{
    auto built = m_programs.get("SPREAD");
    if (!built) {
        return built.error();
    }
    ShaderProgram& program = *built.value();
    program.use();
    program.set("occlusion", 0);
    program.set("spread", way);
    program.set("last", coarseSize() - 1);
    bindAt(0, m_found[from]);
    glBindFramebuffer(GL_FRAMEBUFFER, m_foundFrames[1 - from].name());
    drawTriangle(context);
    return {};
}

Result<void> OcclusionPass::apply(const PassContext& context)
{
    auto built = m_programs.get("APPLIED");
    if (!built) {
        return built.error();
    }
    ShaderProgram& program = *built.value();
    program.use();
    program.set("occlusion", 0);
    program.set("strength", context.style.occlusion);
    bindAt(0, m_found[0]);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER); // nothing where the sky will be
    glEnable(GL_BLEND);
    blendMultiplying();
    drawTriangle(context);
    blendOver(context.input.isTransparent);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LEQUAL);
    return {};
}

Result<void> OcclusionPass::draw(const PassContext& context, const DepthCopy& depths,
                                 const PictureTarget& target)
{
    const int coarseness = isQuick(context) ? 3 : 2;
    if (m_size != target.size() || m_coarseness != coarseness) {
        m_size = target.size();
        m_coarseness = coarseness;
        m_isUsable = make();
    }
    if (!m_isUsable) {
        target.bind();
        return {};
    }
    glBindVertexArray(m_nothing.name());
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    auto drawn = find(context, depths);
    drawn = drawn ? spread(context, 0, {1, 0}) : drawn;
    drawn = drawn ? spread(context, 1, {0, 1}) : drawn;
    target.bind();
    drawn = drawn ? apply(context) : drawn;
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    return drawn;
}

} // namespace crowd::render
