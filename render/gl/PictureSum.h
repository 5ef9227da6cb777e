// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include "model/base/Result.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderVariants.h"

namespace crowd::render {

/// The mean of pictures that follow each other: linear, half a float each.
class PictureSum
{
public:
    /// Takes in the n-th picture, from 0, and writes the mean of all so far to `framebuffer`,
    /// which `picture` is the texture of: sRGB, `size` pixels. Leaves it bound.
    [[nodiscard]] model::Result<void> add(int n, std::uint32_t picture, std::uint32_t framebuffer,
                                          glm::ivec2 size);

private:
    [[nodiscard]] bool make(glm::ivec2 size);
    [[nodiscard]] model::Result<void> draw(std::uint32_t picture);

    ShaderVariants m_programs{"sum"};
    GlVertexArray m_nothing;
    GlTexture m_mean;
    GlFramebuffer m_frame;
    glm::ivec2 m_size{0};
    bool m_isUsable = false;
    int m_count = 0; ///< pictures in it
};

} // namespace crowd::render
