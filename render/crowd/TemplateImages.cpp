// SPDX-License-Identifier: MIT
#include "render/crowd/TemplateImages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "model/base/Color.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr float kBlendCutoff = 1.0F / 255.0F; ///< what is clear is not drawn at all

const std::array<float, 256>& linearTable()
{
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = linearFromSrgb(static_cast<float>(i) / 255.0F);
        }
        return values;
    }();
    return table;
}

std::uint8_t toByte(float value)
{
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

struct Span
{
    int begin;
    int end;
};

/// Source texels under a target texel; at least one.
Span sourceSpan(int index, int target, int source)
{
    const int begin = static_cast<int>(static_cast<std::int64_t>(index) * source / target);
    const auto end = static_cast<int>((static_cast<std::int64_t>(index) + 1) * source / target);
    return {std::min(begin, source - 1), std::clamp(end, begin + 1, source)};
}

int fittingSize(int largest)
{
    int size = 1;
    while (size < largest && size < kMaxLayerSize) {
        size *= 2;
    }
    return size;
}

class Layers
{
public:
    Layers(const Template& asset, TemplateImages& out) : m_asset(asset), m_out(out)
    {
        const auto texels =
            static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height);
        out.layers.emplace_back(texels * 4, std::uint8_t{255});
    }

    /// Picture and mask of an opaque material in one layer.
    int combined(int image, int mask)
    {
        if (image < 0 && mask < 0) {
            return 0;
        }
        return layer(image, mask, true, [this, mask](std::vector<std::uint8_t>& texels) {
            const std::vector<std::uint8_t> red = mask >= 0 ? pixels(mask) : texels;
            for (std::size_t i = 0; i < texels.size(); i += 4) {
                texels[i + 3] = mask >= 0 ? red[i] : std::uint8_t{255};
            }
        });
    }

    int plain(int image)
    {
        return image < 0 ? 0 : layer(image, -1, false, [](std::vector<std::uint8_t>&) {});
    }

    int mask(int image)
    {
        return layer(-1, image, false,
                     [this, image](std::vector<std::uint8_t>& texels) { texels = pixels(image); });
    }

private:
    std::vector<std::uint8_t> pixels(int image) const
    {
        return resized(m_asset.images[static_cast<std::size_t>(image)], m_out.width, m_out.height);
    }

    template<class Edit>
    int layer(int image, int mask, bool isCombined, const Edit& edit)
    {
        const auto next = static_cast<int>(m_out.layers.size());
        const auto [found, isNew] = m_made.try_emplace({image, mask, isCombined}, next);
        if (isNew) {
            std::vector<std::uint8_t> texels = image >= 0 ? pixels(image) : m_out.layers.front();
            edit(texels);
            m_out.layers.push_back(std::move(texels));
        }
        return found->second;
    }

    const Template& m_asset;
    TemplateImages& m_out;
    std::map<std::tuple<int, int, bool>, int> m_made;
};

MaterialRecord recordOf(const MaterialChoice& choice, bool isTintable, bool isOpaqueSlot,
                        Layers& layers)
{
    MaterialRecord record;
    const int mask = isTintable ? choice.tintMask : -1;
    record.baseColor = choice.baseColor;
    record.layer = static_cast<float>(isOpaqueSlot ? layers.combined(choice.image, mask)
                                                   : layers.plain(choice.image));
    record.maskLayer = !isOpaqueSlot && mask >= 0 ? static_cast<float>(layers.mask(mask)) : -1.0F;
    record.alphaCutoff = choice.alphaMode == AlphaMode::Opaque ? -1.0F
                         : choice.alphaMode == AlphaMode::Mask ? choice.alphaCutoff
                                                               : kBlendCutoff;
    record.unlit = choice.unlit ? 1.0F : 0.0F;
    const std::array<float, 6>& uv = choice.uvTransform;
    record.uvRowU = {uv[0], uv[1], uv[2], 0.0F};
    record.uvRowV = {uv[3], uv[4], uv[5], 0.0F};
    record.emissive = glm::vec4(choice.emissive, 0.0F);
    return record;
}

float luminance(const glm::vec3& linear)
{
    return glm::dot(linear, glm::vec3(0.2126F, 0.7152F, 0.0722F));
}

const std::uint8_t* texelAt(const TemplateImages& images, int layer, const glm::vec2& uv)
{
    const glm::vec2 place = glm::fract(uv) * glm::vec2(images.width, images.height);
    const int x = std::clamp(static_cast<int>(place.x), 0, images.width - 1);
    const int y = std::clamp(static_cast<int>(place.y), 0, images.height - 1);
    const auto texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(images.width) +
                       static_cast<std::size_t>(x);
    return &images.layers[static_cast<std::size_t>(layer)][texel * 4];
}

/// Mean luminance of a slot's material where a tint colours it, over its triangles.
float tintedLuminance(const Template& asset, int slot, const MaterialRecord& record,
                      bool isOpaqueSlot, const TemplateImages& images)
{
    const glm::vec3 base(record.baseColor);
    const auto layer = static_cast<int>(record.layer);
    if (layer == 0 || asset.levels.empty() || asset.levels.front().uv.empty()) {
        return luminance(base);
    }
    const Mesh& mesh = asset.levels.front();
    float sum = 0.0F;
    float weight = 0.0F;
    for (const Submesh& submesh : mesh.submeshes) {
        for (std::uint32_t i = 0; submesh.slot == slot && i + 2 < submesh.indexCount; i += 3) {
            const std::uint32_t* corner = &mesh.indices[submesh.firstIndex + i];
            const glm::vec3 side = mesh.positions[corner[1]] - mesh.positions[corner[0]];
            const glm::vec3 other = mesh.positions[corner[2]] - mesh.positions[corner[0]];
            const glm::vec3 uv(
                (mesh.uv[corner[0]] + mesh.uv[corner[1]] + mesh.uv[corner[2]]) / 3.0F, 1.0F);
            const std::uint8_t* texel = texelAt(
                images, layer,
                {glm::dot(glm::vec3(record.uvRowU), uv), glm::dot(glm::vec3(record.uvRowV), uv)});
            const std::array<float, 256>& linear = linearTable();
            const float area = glm::length(glm::cross(side, other)) *
                               (isOpaqueSlot ? static_cast<float>(texel[3]) / 255.0F : 1.0F);
            sum += area * luminance(base * glm::vec3(linear[texel[0]], linear[texel[1]],
                                                     linear[texel[2]]));
            weight += area;
        }
    }
    return weight > 0.0F ? sum / weight : luminance(base);
}

void chooseSampling(const Template& asset, TemplateImages& out)
{
    bool isFirst = true;
    for (const Slot& slot : asset.slots) {
        for (const MaterialChoice& choice : slot.choices) {
            if (choice.image < 0) {
                continue;
            }
            const Image& image = asset.images[static_cast<std::size_t>(choice.image)];
            out.width = std::max(out.width, fittingSize(image.width));
            out.height = std::max(out.height, fittingSize(image.height));
            out.isNearest = choice.nearest && (isFirst || out.isNearest);
            if (isFirst) {
                out.wrapU = choice.wrapU;
                out.wrapV = choice.wrapV;
            }
            isFirst = false;
        }
    }
}

} // namespace

std::vector<std::uint8_t> resized(const Image& image, int width, int height)
{
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (image.width <= 0 || image.height <= 0) {
        return std::vector<std::uint8_t>(count * 4, std::uint8_t{255});
    }
    if (image.width == width && image.height == height) {
        return image.rgba;
    }
    const std::array<float, 256>& linear = linearTable();
    std::vector<std::uint8_t> out(count * 4);
    for (int y = 0; y < height; ++y) {
        const Span rows = sourceSpan(y, height, image.height);
        for (int x = 0; x < width; ++x) {
            const Span columns = sourceSpan(x, width, image.width);
            std::array<float, 4> sum{};
            for (int sy = rows.begin; sy < rows.end; ++sy) {
                for (int sx = columns.begin; sx < columns.end; ++sx) {
                    const std::uint8_t* texel =
                        image.rgba.data() +
                        (static_cast<std::size_t>(sy) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(sx)) *
                            4;
                    sum[0] += linear[texel[0]];
                    sum[1] += linear[texel[1]];
                    sum[2] += linear[texel[2]];
                    sum[3] += static_cast<float>(texel[3]) / 255.0F;
                }
            }
            const auto area =
                static_cast<float>((rows.end - rows.begin) * (columns.end - columns.begin));
            std::uint8_t* target =
                out.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(x)) *
                                 4;
            for (std::size_t c = 0; c < 3; ++c) {
                target[c] = toByte(srgbFromLinear(sum[c] / area));
            }
            target[3] = toByte(sum[3] / area);
        }
    }
    return out;
}

TemplateImages templateImages(const Template& asset)
{
    TemplateImages out;
    chooseSampling(asset, out);
    for (const Slot& slot : asset.slots) {
        out.choicesPerSlot = std::max(out.choicesPerSlot, static_cast<int>(slot.choices.size()));
    }
    Layers layers(asset, out);
    for (std::size_t index = 0; index < asset.slots.size(); ++index) {
        const Slot& slot = asset.slots[index];
        const bool isOpaque = std::ranges::all_of(slot.choices, [](const MaterialChoice& choice) {
            return choice.alphaMode == AlphaMode::Opaque;
        });
        for (std::size_t i = 0; i < static_cast<std::size_t>(out.choicesPerSlot); ++i) {
            const MaterialChoice& choice = slot.choices[i < slot.choices.size() ? i : 0];
            MaterialRecord record = recordOf(choice, slot.tintable, isOpaque, layers);
            record.uvRowU.w = slot.tintable ? tintedLuminance(asset, static_cast<int>(index),
                                                              record, isOpaque, out)
                                            : 1.0F;
            out.materials.push_back(record);
        }
    }
    return out;
}

} // namespace crowd::render
