// SPDX-License-Identifier: MIT
#include "model/gltf/GltfGloss.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/vec4.hpp>

#include "model/gltf/GltfImages.h"
#include "model/gltf/GltfValue.h"

namespace crowd::model::gltf {

namespace {

/// 0..1; `fallback` where it is no number.
float shareOf(double value, float fallback)
{
    return std::isfinite(value) ? static_cast<float>(std::clamp(value, 0.0, 1.0)) : fallback;
}

/// KHR_materials_pbrSpecularGlossiness: glossiness is in the alpha of the specular picture.
Gloss glossOfGlossiness(const tinygltf::Value& extension, ImageTable& images)
{
    float glossiness = shareOf(numberIn(extension, "glossinessFactor").value_or(1.0), 1.0F);
    if (const tinygltf::Value* picture = find(extension, "specularGlossinessTexture")) {
        const std::optional<glm::vec4> mean = images.meanOf(wholeIn(*picture, "index", -1));
        glossiness *= mean ? mean->w : 0.0F;
    }
    return {1.0F - glossiness, 0.0F};
}

} // namespace

Gloss glossOf(const tinygltf::Material& material, ImageTable& images)
{
    if (find(material.extensions, "KHR_materials_unlit") != nullptr) {
        return {};
    }
    if (const auto* extension = find(material.extensions, "KHR_materials_pbrSpecularGlossiness")) {
        return glossOfGlossiness(*extension, images);
    }
    const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
    Gloss gloss{shareOf(pbr.roughnessFactor, 1.0F), shareOf(pbr.metallicFactor, 0.0F)};
    if (pbr.metallicRoughnessTexture.index >= 0) {
        const std::optional<glm::vec4> mean = images.meanOf(pbr.metallicRoughnessTexture.index);
        if (!mean) {
            return {};
        }
        gloss.roughness *= mean->y;
        gloss.metallic *= mean->z;
    }
    return gloss;
}

} // namespace crowd::model::gltf
