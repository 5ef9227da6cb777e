// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

#include "model/template/Template.h"

/// The pictures of a template as layers of equal size, and the table of its materials that refers
/// to them. No GL.
namespace crowd::render {

/// Five texels a material; as in crowd.vert.
struct MaterialRecord
{
    glm::vec4 baseColor{1.0F};
    float layer = 0.0F;
    float maskLayer = -1.0F;
    float alphaCutoff = 0.0F;
    float unlit = 0.0F;
    glm::vec4 uvRowU{1.0F, 0.0F, 0.0F, 1.0F}; ///< w: mean luminance where a tint colours it
    glm::vec4 uvRowV{0.0F, 1.0F, 0.0F, 0.0F};
    glm::vec4 emissive{0.0F};
};
static_assert(sizeof(MaterialRecord) == 80);

struct TemplateImages
{
    int width = 1;
    int height = 1;
    /// RGBA8, sRGB; layer 0 is white. An opaque material's layer holds its tint mask in alpha (1
    /// where it has none); others keep their alpha and have the mask in a layer of its own.
    std::vector<std::vector<std::uint8_t>> layers;
    bool isNearest = false;
    model::Wrap wrapU = model::Wrap::Repeat;
    model::Wrap wrapV = model::Wrap::Repeat;
    int choicesPerSlot = 1;
    std::vector<MaterialRecord>
        materials; ///< slots × choicesPerSlot; missing choices repeat the first
};

/// Largest side of a layer; larger pictures are reduced.
inline constexpr int kMaxLayerSize = 1024;

[[nodiscard]] TemplateImages templateImages(const model::Template& asset);

/// `image` resampled, area-weighted in linear light when it shrinks.
[[nodiscard]] std::vector<std::uint8_t> resized(const model::Image& image, int width, int height);

} // namespace crowd::render
