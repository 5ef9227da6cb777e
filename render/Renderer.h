// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "model/base/Result.h"
#include "render/AovPicture.h"
#include "render/RenderInput.h"

namespace crowd::render {

/// Draws a scene and its crowd with OpenGL 3.3 core, in a window's context or in one without a
/// display. Owns its GL objects and what was uploaded; owns nothing of the model. All functions
/// are called on one thread with the same context current, except construction.
/// A renderer that has lost its context is used again after abandon() and initialize().
class Renderer
{
public:
    Renderer();
    ~Renderer(); ///< destroy() or abandon() came before
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Needs OpenGL 3.3; says what the context offers otherwise.
    [[nodiscard]] model::Result<void> initialize();
    [[nodiscard]] bool isInitialized() const;
    /// Releases every GL object; the context is current.
    void destroy();
    /// Forgets every GL object without touching GL: the context died before.
    void abandon();

    /// Frees what the last picture did not show; what comes back is sent anew. What was reduced for
    /// want of memory is tried in full again. The context is current.
    void releaseUnused();

    /// Where the graphics card has no room for all of it, a picture is drawn coarser
    /// (RenderStatistics::reduction); an error says when that does not help either.

    /// Draws into a framebuffer (0: the window's own) at the origin, in physical pixels, opaque,
    /// sRGB-encoded. Leaves the framebuffer bound and GL state as QOpenGLWidget and QPainter expect
    /// it (no program, no array, no blending, depth test off).
    [[nodiscard]] model::Result<void> draw(const RenderInput& input, std::uint32_t framebuffer);
    /// Draws into the renderer's own framebuffer: what readPixels() gives.
    [[nodiscard]] model::Result<void> draw(const RenderInput& input);

    /// The last picture: RGBA8, sRGB; of a deep one four half floats a pixel. Rows from the top,
    /// size() wide and high.
    [[nodiscard]] std::vector<std::uint8_t> readPixels() const;
    [[nodiscard]] glm::ivec2 size() const;

    /// What the picture of this input shows, besides its colours: the same people at the same
    /// levels, without anything that is drawn over them; against input.earlier, how they move. What
    /// was drawn last stays in readPixels().
    [[nodiscard]] model::Result<AovPicture> drawAovs(const RenderInput& input);

    [[nodiscard]] const RenderStatistics& statistics() const;

private:
    struct Private;
    std::unique_ptr<Private> m_private;
};

} // namespace crowd::render
