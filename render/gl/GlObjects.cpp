// SPDX-License-Identifier: MIT
#include "render/gl/GlObjects.h"

#include <algorithm>
#include <cassert>

#include <epoxy/gl.h>

#include "render/gl/CardMemory.h"

namespace crowd::render {

namespace {

thread_local int lostScopes = 0;

} // namespace

ContextLostScope::ContextLostScope()
{
    ++lostScopes;
}

ContextLostScope::~ContextLostScope()
{
    --lostScopes;
}

template<GlKind kind>
GlObject<kind> GlObject<kind>::create()
{
    GLuint name = 0;
    if constexpr (kind == GlKind::Buffer) {
        glGenBuffers(1, &name);
    } else if constexpr (kind == GlKind::Texture) {
        glGenTextures(1, &name);
    } else if constexpr (kind == GlKind::VertexArray) {
        glGenVertexArrays(1, &name);
    } else if constexpr (kind == GlKind::Framebuffer) {
        glGenFramebuffers(1, &name);
    } else if constexpr (kind == GlKind::Renderbuffer) {
        glGenRenderbuffers(1, &name);
    } else {
        name = glCreateProgram();
    }
    return GlObject(name);
}

template<GlKind kind>
void GlObject<kind>::reset()
{
    const GLuint name = std::exchange(m_name, 0U);
    card_memory::giveBack(std::exchange(m_bytes, 0U));
    if (name == 0 || lostScopes > 0) {
        return;
    }
    if constexpr (kind == GlKind::Buffer) {
        glDeleteBuffers(1, &name);
    } else if constexpr (kind == GlKind::Texture) {
        glDeleteTextures(1, &name);
    } else if constexpr (kind == GlKind::VertexArray) {
        glDeleteVertexArrays(1, &name);
    } else if constexpr (kind == GlKind::Framebuffer) {
        glDeleteFramebuffers(1, &name);
    } else if constexpr (kind == GlKind::Renderbuffer) {
        glDeleteRenderbuffers(1, &name);
    } else {
        glDeleteProgram(name);
    }
}

template<GlKind kind>
bool GlObject<kind>::take(std::size_t bytes)
{
    if (bytes <= m_bytes) {
        card_memory::giveBack(m_bytes - bytes);
    } else if (!card_memory::take(bytes - m_bytes)) {
        return false;
    }
    m_bytes = bytes;
    return true;
}

template class GlObject<GlKind::Buffer>;
template class GlObject<GlKind::Texture>;
template class GlObject<GlKind::VertexArray>;
template class GlObject<GlKind::Framebuffer>;
template class GlObject<GlKind::Renderbuffer>;
template class GlObject<GlKind::Program>;

void TexelBuffer::reserve(std::size_t bytes)
{
    if (m_buffer && bytes <= m_capacity) {
        return;
    }
    const std::size_t capacity = std::max({bytes, m_capacity + m_capacity / 2, std::size_t{256}});
    GlBuffer grown = GlBuffer::create();
    glBindBuffer(GL_COPY_WRITE_BUFFER, grown.name());
    if (grown.take(capacity)) {
        glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(capacity), nullptr,
                     GL_DYNAMIC_DRAW);
    }
    if (m_buffer) {
        glBindBuffer(GL_COPY_READ_BUFFER, m_buffer.name());
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                            static_cast<GLsizeiptr>(m_capacity));
    }
    m_buffer = std::move(grown);
    m_capacity = capacity;
    if (!m_texture) {
        m_texture = GlTexture::create();
    }
    glBindTexture(GL_TEXTURE_BUFFER, m_texture.name());
    glTexBuffer(GL_TEXTURE_BUFFER, m_format, m_buffer.name());
}

void TexelBuffer::write(std::size_t offset, std::span<const std::byte> bytes)
{
    assert(offset + bytes.size() <= m_capacity);
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_buffer.name());
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset),
                    static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void TexelBuffer::bind(int textureUnit) const
{
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(textureUnit));
    glBindTexture(GL_TEXTURE_BUFFER, m_texture.name());
}

void stream(GlBuffer& buffer, std::span<const std::byte> bytes)
{
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    if (buffer.take(bytes.size())) {
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
                     GL_STREAM_DRAW);
    }
}

GlBuffer makeBuffer(std::uint32_t target, std::span<const std::byte> bytes)
{
    GlBuffer buffer = GlBuffer::create();
    glBindBuffer(target, buffer.name());
    if (buffer.take(bytes.size())) {
        glBufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    }
    return buffer;
}

} // namespace crowd::render
