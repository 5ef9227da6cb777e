// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <glm/vec2.hpp>

/// Owners of GL names: created empty, released with the context current. Where the context is gone
/// already, they die inside a ContextLostScope and touch nothing.
namespace crowd::render {

/// An offset into the bound buffer as GL's functions take it.
[[nodiscard]] inline const void* bufferOffset(std::size_t bytes)
{
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    return reinterpret_cast<const void*>(bytes);
}

/// While one lives on this thread, owners of GL names forget them instead of deleting them.
class ContextLostScope
{
public:
    ContextLostScope();
    ~ContextLostScope();
    ContextLostScope(const ContextLostScope&) = delete;
    ContextLostScope& operator=(const ContextLostScope&) = delete;
};

enum class GlKind : std::uint8_t {
    Buffer,
    Texture,
    VertexArray,
    Framebuffer,
    Renderbuffer,
    Program
};

template<GlKind kind>
class GlObject
{
public:
    GlObject() = default;
    explicit GlObject(std::uint32_t name) : m_name(name) {}
    ~GlObject() { reset(); }
    GlObject(GlObject&& other) noexcept
        : m_name(std::exchange(other.m_name, 0U)), m_bytes(std::exchange(other.m_bytes, 0U))
    {
    }
    GlObject& operator=(GlObject&& other) noexcept
    {
        if (this != &other) {
            reset();
            m_name = std::exchange(other.m_name, 0U);
            m_bytes = std::exchange(other.m_bytes, 0U);
        }
        return *this;
    }

    [[nodiscard]] static GlObject create();
    void reset();
    /// Counts so many bytes (card_memory) as what it holds, instead of those before. False: there
    /// is no room for them, and GL is not to be asked.
    [[nodiscard]] bool take(std::size_t bytes);
    [[nodiscard]] std::uint32_t name() const { return m_name; }
    explicit operator bool() const { return m_name != 0; }

private:
    std::uint32_t m_name = 0;
    std::size_t m_bytes = 0;
};

using GlBuffer = GlObject<GlKind::Buffer>;
using GlTexture = GlObject<GlKind::Texture>;
using GlVertexArray = GlObject<GlKind::VertexArray>;
using GlFramebuffer = GlObject<GlKind::Framebuffer>;
using GlRenderbuffer = GlObject<GlKind::Renderbuffer>;
using GlProgram = GlObject<GlKind::Program>;

/// A buffer that shaders read through texelFetch; grows, keeping what is in it.
class TexelBuffer
{
public:
    explicit TexelBuffer(std::uint32_t internalFormat) : m_format(internalFormat) {}

    /// At least this many bytes; existing contents stay.
    void reserve(std::size_t bytes);
    /// Within what was reserved.
    void write(std::size_t offset, std::span<const std::byte> bytes);
    void bind(int textureUnit) const;
    [[nodiscard]] std::size_t capacity() const { return m_capacity; }

private:
    std::uint32_t m_format;
    std::size_t m_capacity = 0;
    GlBuffer m_buffer;
    GlTexture m_texture;
};

/// Of a picture.
[[nodiscard]] inline std::size_t pixelBytes(const glm::ivec2& size, std::size_t bytesPerPixel)
{
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * bytesPerPixel;
}

/// What changes with every picture; the buffer stays bound as GL_ARRAY_BUFFER.
void stream(GlBuffer& buffer, std::span<const std::byte> bytes);

/// A static buffer with the given contents.
[[nodiscard]] GlBuffer makeBuffer(std::uint32_t target, std::span<const std::byte> bytes);

} // namespace crowd::render
