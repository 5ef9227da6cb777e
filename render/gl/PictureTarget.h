// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "model/base/Result.h"
#include "render/gl/GlObjects.h"

namespace crowd::render {

/// What a picture's colours are held as.
enum class PixelKind : std::uint8_t {
    Bytes, ///< RGBA8, sRGB
    Halves ///< four half floats, linear
};

/// The framebuffer a picture is drawn into: several samples a pixel, physical pixels; and the one
/// with a sample a pixel that it is resolved into.
class PictureTarget
{
public:
    /// Makes the framebuffers anew if any of these differs from the last call's; binds the one that
    /// is drawn into.
    [[nodiscard]] model::Result<void> begin(glm::ivec2 size, int samples,
                                            PixelKind kind = PixelKind::Bytes);
    /// Draws into it again.
    void bind() const;
    /// Copies what it has of depth to a framebuffer of the same size and format; leaves that one
    /// bound.
    void copyDepth(std::uint32_t framebuffer) const;
    /// What was drawn, with a sample a pixel, is in resolved() from now on; that is bound.
    void resolve();
    /// Copies what is resolved to `framebuffer`'s origin unless it is null. Leaves that one (or the
    /// resolved one) bound. Where something more is drawn from resolved(), the copy is needed and
    /// goes to a framebuffer of its own instead of none. What is drawn then is encoded already: not
    /// of halves.
    void end(const std::uint32_t* framebuffer, bool needsCopy);
    /// After end() without a framebuffer: the finished picture goes to that one, scaled to its
    /// size; leaves that bound.
    void scaleTo(std::uint32_t framebuffer, glm::ivec2 size) const;
    /// The texture with the resolved picture, alpha as it was drawn.
    [[nodiscard]] std::uint32_t resolved() const { return m_resolvedColor.name(); }
    /// The framebuffer of that texture.
    [[nodiscard]] std::uint32_t resolvedFrame() const;
    /// The finished picture, rows from the top.
    [[nodiscard]] std::vector<std::uint8_t> read() const;
    [[nodiscard]] glm::ivec2 size() const { return m_size; }

private:
    [[nodiscard]] model::Result<void> make();
    void makeCopy();

    glm::ivec2 m_size{0};
    int m_samples = -1;
    PixelKind m_kind = PixelKind::Bytes;
    GlFramebuffer m_drawn;
    GlRenderbuffer m_drawnColor;
    GlRenderbuffer m_drawnDepth;
    GlFramebuffer m_resolved;
    GlTexture m_resolvedColor; ///< drawn into at once where a pixel has one sample
    GlFramebuffer m_copy;      ///< made when first needed
    GlRenderbuffer m_copyColor;
    GlRenderbuffer m_copyMarks; ///< depth and stencil
    bool m_isCopied = false;    ///< the finished picture is there, not in m_resolved
};

} // namespace crowd::render
