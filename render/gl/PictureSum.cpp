// SPDX-License-Identifier: MIT
#include "render/gl/PictureSum.h"

#include <epoxy/gl.h>

#include "render/gl/Blending.h"

namespace crowd::render {

bool PictureSum::make(glm::ivec2 size)
{
    m_size = size;
    m_nothing = GlVertexArray::create();
    m_mean = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, m_mean.name());
    if (m_mean.take(pixelBytes(size, 8))) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, size.x, size.y, 0, GL_RGBA, GL_HALF_FLOAT,
                     nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    m_frame = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, m_frame.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_mean.name(), 0);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

model::Result<void> PictureSum::draw(std::uint32_t picture)
{
    auto built = m_programs.get("");
    if (!built) {
        return built.error();
    }
    built.value()->use();
    built.value()->set("picture", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D, 0);
    return {};
}

model::Result<void> PictureSum::add(int n, std::uint32_t picture, std::uint32_t framebuffer,
                                    glm::ivec2 size)
{
    if (m_size != size) {
        m_isUsable = make(size);
        m_count = 0;
    }
    m_count = n == m_count ? n + 1 : 1; // one that does not follow the last begins anew
    if (!m_isUsable) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        return {}; // the last one stands for all
    }
    glBindVertexArray(m_nothing.name());
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glBindFramebuffer(GL_FRAMEBUFFER, m_frame.name());
    glViewport(0, 0, size.x, size.y);
    if (m_count > 1) {
        glEnable(GL_BLEND);
        glBlendColor(0.0F, 0.0F, 0.0F, 1.0F / static_cast<float>(m_count));
        glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    } else {
        glDisable(GL_BLEND);
    }
    auto drawn = draw(picture);
    glDisable(GL_BLEND);
    blendOver(false);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (drawn && m_count > 1) {
        drawn = draw(m_mean.name());
    }
    return drawn;
}

} // namespace crowd::render
