// SPDX-License-Identifier: MIT
#include "render/gl/AovTarget.h"

#include <array>
#include <cmath>
#include <cstddef>

#include <epoxy/gl.h>
#include <glm/vec4.hpp>

namespace crowd::render {

namespace {

GlRenderbuffer attachStorage(GLenum format, std::size_t bytesPerPixel, GLenum attachment,
                             glm::ivec2 size)
{
    GlRenderbuffer storage = GlRenderbuffer::create();
    glBindRenderbuffer(GL_RENDERBUFFER, storage.name());
    if (storage.take(pixelBytes(size, bytesPerPixel))) {
        glRenderbufferStorage(GL_RENDERBUFFER, format, size.x, size.y);
    }
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, storage.name());
    return storage;
}

/// Rows from the top.
template<class Use>
void readRows(GLenum attachment, glm::ivec2 size, const Use& use)
{
    std::vector<glm::vec4> row(static_cast<std::size_t>(size.x));
    glReadBuffer(attachment);
    for (int y = size.y - 1; y >= 0; --y) {
        glReadPixels(0, y, size.x, 1, GL_RGBA, GL_FLOAT, row.data());
        for (const glm::vec4& pixel : row) {
            use(pixel);
        }
    }
}

} // namespace

model::Result<void> AovTarget::begin(glm::ivec2 size, bool hasMotion)
{
    m_size = size;
    m_hasMotion = hasMotion;
    m_frame = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, m_frame.name());
    m_places = attachStorage(GL_RGBA32F, 16, GL_COLOR_ATTACHMENT0, size);
    m_normals = attachStorage(GL_RGBA16F, 8, GL_COLOR_ATTACHMENT1, size);
    if (hasMotion) {
        m_before = attachStorage(GL_RG32F, 8, GL_COLOR_ATTACHMENT2, size);
    }
    m_depth = attachStorage(GL_DEPTH24_STENCIL8, 4, GL_DEPTH_STENCIL_ATTACHMENT, size);
    constexpr std::array<GLenum, 3> kDrawn{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                           GL_COLOR_ATTACHMENT2};
    glDrawBuffers(hasMotion ? 3 : 2, kDrawn.data());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages", "The graphics driver offers no framebuffer of numbers of "
                                          "%1 by %2 pixels. Try a smaller picture."),
            size.x, size.y};
    }
    glViewport(0, 0, size.x, size.y);
    constexpr std::array<float, 4> kEmpty{0.0F, 0.0F, 0.0F, AovPicture::kNothing};
    constexpr std::array<float, 4> kFlat{0.0F, 0.0F, 0.0F, 0.0F};
    glClearBufferfv(GL_COLOR, 0, kEmpty.data());
    glClearBufferfv(GL_COLOR, 1, kFlat.data());
    if (hasMotion) {
        glClearBufferfv(GL_COLOR, 2, kFlat.data());
    }
    glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    return {};
}

AovPicture AovTarget::take()
{
    AovPicture picture;
    picture.size = m_size;
    const auto count = static_cast<std::size_t>(m_size.x) * static_cast<std::size_t>(m_size.y);
    picture.places.reserve(count);
    picture.rows.reserve(count);
    picture.normals.reserve(count);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_frame.name());
    readRows(GL_COLOR_ATTACHMENT0, m_size, [&picture](const glm::vec4& pixel) {
        picture.places.emplace_back(pixel);
        picture.rows.push_back(static_cast<std::int32_t>(std::lround(pixel.w)));
    });
    readRows(GL_COLOR_ATTACHMENT1, m_size,
             [&picture](const glm::vec4& pixel) { picture.normals.emplace_back(pixel); });
    if (m_hasMotion) {
        picture.before.reserve(count);
        readRows(GL_COLOR_ATTACHMENT2, m_size,
                 [&picture](const glm::vec4& pixel) { picture.before.emplace_back(pixel); });
    }
    *this = {};
    return picture;
}

} // namespace crowd::render
