// SPDX-License-Identifier: MIT
#include "render/gl/DepthCopy.h"

#include <epoxy/gl.h>

namespace crowd::render {

bool DepthCopy::make(glm::ivec2 size)
{
    m_depth = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, m_depth.name());
    if (m_depth.take(pixelBytes(size, 4))) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, size.x, size.y, 0, GL_DEPTH_STENCIL,
                     GL_UNSIGNED_INT_24_8, nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    m_frame = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, m_frame.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D,
                           m_depth.name(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool DepthCopy::take(const PictureTarget& target)
{
    if (m_size != target.size()) {
        m_size = target.size();
        m_isUsable = make(m_size);
    }
    if (m_isUsable) {
        target.copyDepth(m_frame.name());
    }
    target.bind();
    return m_isUsable;
}

glm::vec4 unprojectOf(const model::View& view)
{
    const glm::mat4& p = view.projectionMatrix();
    const glm::vec2 half(1.0F / p[0][0], 1.0F / p[1][1]);
    if (view.camera().projection == model::Projection::Perspective) {
        return {half, p[3][2] * 0.5F, (p[2][2] - 1.0F) * 0.5F};
    }
    return {half, -2.0F / p[2][2], (p[3][2] + 1.0F) / p[2][2]};
}

glm::vec2 axisOf(const model::View& view)
{
    const glm::mat4& p = view.projectionMatrix();
    const bool isPerspective = view.camera().projection == model::Projection::Perspective;
    return isPerspective ? -glm::vec2(p[2]) : glm::vec2(p[3]);
}

} // namespace crowd::render
