// SPDX-License-Identifier: MIT
#include "render/gl/ShadowTarget.h"

#include <array>

#include <epoxy/gl.h>

namespace crowd::render {

bool ShadowTarget::begin(int pixels, const ShadowTarget* other)
{
    if (pixels != m_pixels) {
        m_pixels = make(pixels) ? pixels : 0;
    }
    if (m_pixels == 0) {
        return false;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.name());
    glViewport(0, 0, pixels, pixels);
    if (other != nullptr) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, other->m_framebuffer.name());
        glBlitFramebuffer(0, 0, pixels, pixels, 0, 0, pixels, pixels, GL_DEPTH_BUFFER_BIT,
                          GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer.name());
    } else {
        glClear(GL_DEPTH_BUFFER_BIT);
    }
    return true;
}

void ShadowTarget::bindTexture(int unit) const
{
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, m_depth.name());
}

bool ShadowTarget::make(int pixels)
{
    m_depth = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, m_depth.name());
    if (m_depth.take(pixelBytes(glm::ivec2(pixels), 2))) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT16, pixels, pixels, 0, GL_DEPTH_COMPONENT,
                     GL_UNSIGNED_SHORT, nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    constexpr std::array<float, 4> kLit{1.0F, 1.0F, 1.0F, 1.0F};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kLit.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glBindTexture(GL_TEXTURE_2D, 0);
    m_framebuffer = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_depth.name(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

} // namespace crowd::render
