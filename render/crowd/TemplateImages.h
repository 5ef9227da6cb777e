// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

#include "model/template/Template.h"
#include "render/gl/Sampling.h"

/// The pictures of a template as layers of equal size, and the table of its materials that refers
/// to them. No GL.
namespace crowd::render {

/// Seven texels a material; as in crowd.vert.
struct MaterialRecord
{
    glm::vec4 baseColor{1.0F};
    float layer = 0.0F;
    float maskLayer = -1.0F;
    float alphaCutoff = 0.0F; ///< from there on it is solid
    float unlit = 0.0F;
    glm::vec4 uvRowU{1.0F, 0.0F, 0.0F, 1.0F};   ///< w: mean luminance where a tint colours it
    glm::vec4 uvRowV{0.0F, 1.0F, 0.0F, 0.0F};   ///< 1 in w: what is not solid is blended
    glm::vec4 emissive{0.0F};                   ///< layer in w
    glm::vec4 glowRowU{1.0F, 0.0F, 0.0F, 1.0F}; ///< w: roughness
    glm::vec4 glowRowV{0.0F, 1.0F, 0.0F, 0.0F}; ///< w: metallic
};
static_assert(sizeof(MaterialRecord) == 112);

/// Pictures that are sampled alike.
struct PictureArray
{
    Sampling sampling;
    int width = 1;
    int height = 1;
    /// RGBA8, sRGB; layer 0 is white. An opaque material's layer holds its tint mask in alpha (1
    /// where it has none); others keep their alpha and have the mask in a layer of its own.
    std::vector<std::vector<std::uint8_t>> layers;
};

struct TemplateImages
{
    std::vector<PictureArray> arrays; ///< never empty
    int choicesPerSlot = 1;
    std::vector<MaterialRecord>
        materials; ///< slots × choicesPerSlot; missing choices repeat the first
};

/// Largest side of a layer; larger pictures are reduced.
inline constexpr int kMaxLayerSize = 1024;
/// Layers of an array: what every card can do (OpenGL 3.3, table 6.50).
inline constexpr std::size_t kMaxLayers = 256;

/// Which of TemplateImages::arrays has the pictures of each slot: one a way of sampling, and
/// further ones where an array is full. A slot's first picture decides for all its choices.
[[nodiscard]] std::vector<int> arraysOfSlots(const model::Template& asset);

/// Their sides halved so many times.
[[nodiscard]] TemplateImages templateImages(const model::Template& asset, int halvings = 0);

/// `image` resampled, area-weighted in linear light when it shrinks.
[[nodiscard]] std::vector<std::uint8_t> resized(const model::Image& image, int width, int height);

} // namespace crowd::render
