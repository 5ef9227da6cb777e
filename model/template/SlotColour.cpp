// SPDX-License-Identifier: MIT
#include "model/template/SlotColour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/Color.h"

namespace crowd::model {

namespace {

constexpr float kByte = 1.0F / 255.0F;

float wrapped(float at, Wrap wrap)
{
    switch (wrap) {
    case Wrap::Repeat:
        return at - std::floor(at);
    case Wrap::Mirror: {
        const float within = at - 2.0F * std::floor(0.5F * at);
        return within > 1.0F ? 2.0F - within : within;
    }
    case Wrap::Clamp:
        break;
    }
    return std::clamp(at, 0.0F, 1.0F);
}

std::size_t texelOf(float share, int count)
{
    const auto texel = static_cast<int>(share * static_cast<float>(count));
    return static_cast<std::size_t>(std::clamp(texel, 0, count - 1));
}

/// Linear; of the texel there.
glm::vec3 texelAt(const Image& image, const MaterialChoice& choice, const glm::vec2& uv)
{
    const std::array<float, 6>& to = choice.uvTransform;
    const glm::vec2 at(to[0] * uv.x + to[1] * uv.y + to[2], to[3] * uv.x + to[4] * uv.y + to[5]);
    const std::size_t x = texelOf(wrapped(at.x, choice.wrapU), image.width);
    const std::size_t y = texelOf(wrapped(at.y, choice.wrapV), image.height);
    const std::size_t first = 4 * (y * static_cast<std::size_t>(image.width) + x);
    return linearFromSrgb(
        kByte * glm::vec3(image.rgba[first], image.rgba[first + 1], image.rgba[first + 2]));
}

/// Null: the material has none that can be read.
const Image* imageOf(const Template& asset, const MaterialChoice& choice)
{
    const auto index = static_cast<std::size_t>(choice.image);
    if (choice.image < 0 || index >= asset.images.size()) {
        return nullptr;
    }
    const Image& image = asset.images[index];
    const std::size_t bytes =
        4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    return bytes > 0 && image.rgba.size() >= bytes ? &image : nullptr;
}

/// Adds up colours, each as much as there is of it.
struct ColourSum
{
    glm::vec3 sum{0.0F};
    float surface = 0.0F;

    void add(const Mesh& mesh, std::span<const std::uint32_t> corners, const Image* image,
             const MaterialChoice& choice)
    {
        const std::array<std::uint32_t, 3> at{corners[0], corners[1], corners[2]};
        const glm::vec3 first = mesh.positions[at[0]];
        const float area = 0.5F * glm::length(glm::cross(mesh.positions[at[1]] - first,
                                                         mesh.positions[at[2]] - first));
        glm::vec3 own(1.0F);
        if (!mesh.colors.empty()) {
            own = glm::vec3(0.0F);
            for (const std::uint32_t corner : at) {
                own += kByte / 3.0F * glm::vec3(mesh.colors[corner]);
            }
        }
        if (image != nullptr && !mesh.uv.empty()) {
            const glm::vec2 middle =
                (mesh.uv[at[0]] + mesh.uv[at[1]] + mesh.uv[at[2]]) * (1.0F / 3.0F);
            own *= texelAt(*image, choice, middle);
        }
        sum += area * own;
        surface += area;
    }
};

} // namespace

glm::vec3 slotColour(const Template& asset, std::size_t slot, std::size_t choice)
{
    const MaterialChoice& material = asset.slots[slot].choices[choice];
    const Image* image = imageOf(asset, material);
    ColourSum seen;
    const Mesh& mesh = asset.levels.front();
    for (const Submesh& each : mesh.submeshes) {
        if (static_cast<std::size_t>(each.slot) != slot) {
            continue;
        }
        const auto indices = std::span(mesh.indices).subspan(each.firstIndex, each.indexCount);
        for (std::size_t i = 0; i + 3 <= indices.size(); i += 3) {
            seen.add(mesh, indices.subspan(i, 3), image, material);
        }
    }
    const glm::vec3 mean = seen.surface > 0.0F ? seen.sum / seen.surface : glm::vec3(1.0F);
    return glm::vec3(material.baseColor) * mean;
}

} // namespace crowd::model
