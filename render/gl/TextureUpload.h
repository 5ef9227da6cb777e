// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "model/template/Template.h"
#include "render/gl/GlObjects.h"
#include "render/gl/Sampling.h"

namespace crowd::render {

/// A texture array with mipmaps from RGBA8 layers of equal size. Values come as they are, encoded:
/// the shader decodes what it sampled, which costs a software rasteriser an eighth of decoding each
/// texel.
[[nodiscard]] GlTexture uploadLayers(int width, int height,
                                     const std::vector<std::vector<std::uint8_t>>& layers,
                                     const Sampling& sampling);
/// An sRGB texture with mipmaps, and one of plain numbers.
[[nodiscard]] GlTexture uploadImage(const model::Image& image, const Sampling& sampling);
[[nodiscard]] GlTexture uploadValues(const model::Image& image, const Sampling& sampling);

} // namespace crowd::render
