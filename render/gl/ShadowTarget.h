// SPDX-License-Identifier: MIT
#pragma once

#include "render/gl/GlObjects.h"

namespace crowd::render {

/// A depth picture that shaders compare with (sampler2DShadow): 1 where nothing is nearer to the
/// light, and all around it.
class ShadowTarget
{
public:
    /// Makes it anew where the size is another; binds it and clears it, or begins it with what is
    /// in another one of that size. A square of pixels. False: the driver offers no such map.
    [[nodiscard]] bool begin(int pixels, const ShadowTarget* other = nullptr);
    void bindTexture(int unit) const;

private:
    [[nodiscard]] bool make(int pixels);

    int m_pixels = 0;
    GlTexture m_depth;
    GlFramebuffer m_framebuffer;
};

} // namespace crowd::render
