// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace crowd::app {

/// How near a picture is to what it ought to look like, of luma.
struct PictureQuality
{
    double psnr = 0.0; ///< peak signal to noise, dB; kSamePsnr where nothing differs
    double ssim = 0.0; ///< structural similarity, at most 1
};

inline constexpr double kSamePsnr = 99.0;

/// Of pictures of the same size, RGBA8, sRGB. Similarity as Z. Wang, A. C. Bovik, H. R. Sheikh and
/// E. P. Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity",
/// 2004, have it: a Gaussian of 11 pixels, its deviation 1.5; the mean over all pixels.
[[nodiscard]] PictureQuality qualityOf(std::span<const std::uint8_t> picture,
                                       std::span<const std::uint8_t> truth, glm::ivec2 size);

/// A picture of twice the width and height, each four pixels of it one, mixed as light.
[[nodiscard]] std::vector<std::uint8_t> halved(std::span<const std::uint8_t> picture,
                                               glm::ivec2 size);

} // namespace crowd::app
