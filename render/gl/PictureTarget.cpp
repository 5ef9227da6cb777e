// SPDX-License-Identifier: MIT
#include "render/gl/PictureTarget.h"

#include <algorithm>
#include <string>

#include <epoxy/gl.h>

namespace crowd::render {

namespace {

GlRenderbuffer makeStorage(GLenum format, std::size_t bytesPerPixel, glm::ivec2 size, int samples)
{
    GlRenderbuffer storage = GlRenderbuffer::create();
    glBindRenderbuffer(GL_RENDERBUFFER, storage.name());
    const auto times = static_cast<std::size_t>(std::max(samples, 1));
    if (storage.take(pixelBytes(size, bytesPerPixel) * times)) {
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.x, size.y);
    }
    return storage;
}

/// What OpenGL calls a kind of pixels.
struct PixelFormat
{
    GLenum inside;
    GLenum type; ///< of each of the four when they are read
    std::size_t bytes;
};

PixelFormat formatOf(PixelKind kind)
{
    return kind == PixelKind::Halves ? PixelFormat{GL_RGBA16F, GL_HALF_FLOAT, 8}
                                     : PixelFormat{GL_SRGB8_ALPHA8, GL_UNSIGNED_BYTE, 4};
}

GlTexture makeTexture(glm::ivec2 size, const PixelFormat& format)
{
    GlTexture texture = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    if (texture.take(pixelBytes(size, format.bytes))) {
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format.inside), size.x, size.y, 0,
                     GL_RGBA, format.type, nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

/// To the bound framebuffer.
void attachPicture(const GlTexture& texture)
{
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
}

bool isComplete()
{
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

} // namespace

model::Result<void> PictureTarget::begin(glm::ivec2 size, int samples, PixelKind kind)
{
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    const int used = std::clamp(samples, 0, static_cast<int>(most));
    if (!m_drawn || size != m_size || used != m_samples || kind != m_kind) {
        m_size = size;
        m_samples = used;
        m_kind = kind;
        if (auto made = make(); !made) {
            m_drawn.reset();
            return made;
        }
    }
    bind();
    return {};
}

void PictureTarget::bind() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, m_drawn.name());
    glViewport(0, 0, m_size.x, m_size.y);
}

void PictureTarget::copyDepth(std::uint32_t framebuffer) const
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_drawn.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, m_size.x, m_size.y, 0, 0, m_size.x, m_size.y, GL_DEPTH_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

model::Result<void> PictureTarget::make()
{
    const PixelFormat format = formatOf(m_kind);
    m_resolvedColor = makeTexture(m_size, format);
    m_drawnDepth = makeStorage(GL_DEPTH24_STENCIL8, 4, m_size, m_samples);
    m_drawn = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, m_drawn.name());
    if (m_samples == 0) {
        m_drawnColor.reset();
        attachPicture(m_resolvedColor);
    } else {
        m_drawnColor = makeStorage(format.inside, format.bytes, m_size, m_samples);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  m_drawnColor.name());
    }
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                              m_drawnDepth.name());
    bool isUsable = isComplete();
    m_copy.reset();
    m_resolved = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, m_resolved.name());
    attachPicture(m_resolvedColor);
    isUsable = isUsable && isComplete();
    if (!isUsable) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages", "The graphics driver offers no framebuffer of %1 by %2 "
                                          "pixels. Try a smaller picture."),
            m_size.x, m_size.y};
    }
    return {};
}

void PictureTarget::makeCopy()
{
    // Not sRGB: what is drawn into it is encoded already, as in a window's framebuffer.
    m_copyColor = makeStorage(GL_RGBA8, 4, m_size, 0);
    m_copy = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, m_copy.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              m_copyColor.name());
    m_copyMarks = makeStorage(GL_DEPTH24_STENCIL8, 4, m_size, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                              m_copyMarks.name());
}

std::uint32_t PictureTarget::resolvedFrame() const
{
    return m_resolved.name();
}

void PictureTarget::resolve()
{
    if (m_samples > 0) {
        // The bytes are copied as they are, encoded.
        glDisable(GL_FRAMEBUFFER_SRGB);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, m_drawn.name());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_resolved.name());
        glBlitFramebuffer(0, 0, m_size.x, m_size.y, 0, 0, m_size.x, m_size.y, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, m_resolved.name());
}

void PictureTarget::end(const std::uint32_t* framebuffer, bool needsCopy)
{
    m_isCopied = needsCopy && framebuffer == nullptr;
    if (m_isCopied && !m_copy) {
        makeCopy();
    }
    const std::uint32_t copy = m_copy.name();
    const std::uint32_t* const target = m_isCopied ? &copy : framebuffer;
    glDisable(GL_FRAMEBUFFER_SRGB); // the bytes are copied as they are, encoded
    if (target != nullptr) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, m_resolved.name());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, *target);
        glBlitFramebuffer(0, 0, m_size.x, m_size.y, 0, 0, m_size.x, m_size.y, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, target != nullptr ? *target : m_resolved.name());
}

void PictureTarget::scaleTo(std::uint32_t framebuffer, glm::ivec2 size) const
{
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_isCopied ? m_copy.name() : m_resolved.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, m_size.x, m_size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT,
                      GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.x, size.y);
}

std::vector<std::uint8_t> PictureTarget::read() const
{
    const PixelFormat format = formatOf(m_kind);
    const std::size_t stride = static_cast<std::size_t>(m_size.x) * format.bytes;
    std::vector<std::uint8_t> pixels(stride * static_cast<std::size_t>(m_size.y));
    GLint before = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &before);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_isCopied ? m_copy.name() : m_resolved.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, m_size.x, m_size.y, GL_RGBA, format.type, pixels.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(before));
    for (int y = 0; y < m_size.y / 2; ++y) {
        std::uint8_t* top = pixels.data() + static_cast<std::size_t>(y) * stride;
        std::uint8_t* bottom = pixels.data() + static_cast<std::size_t>(m_size.y - 1 - y) * stride;
        std::swap_ranges(top, top + stride, bottom);
    }
    return pixels;
}

} // namespace crowd::render
