// SPDX-License-Identifier: MIT
#include "render/crowd/TemplateImages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "model/base/Color.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr float kSolid = 254.0F / 255.0F; ///< alpha from which blending makes no difference
constexpr std::size_t kMaxArrayBytes = std::size_t{1} << 29U; ///< without mipmaps

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
    Layers(const Template& asset, PictureArray& out) : m_asset(asset), m_out(out)
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
        if (m_out.layers.size() >= kMaxLayers && !m_made.contains({image, mask, isCombined})) {
            return 0;
        }
        const auto [found, isNew] = m_made.try_emplace({image, mask, isCombined}, next);
        if (isNew) {
            std::vector<std::uint8_t> texels = image >= 0 ? pixels(image) : m_out.layers.front();
            edit(texels);
            m_out.layers.push_back(std::move(texels));
        }
        return found->second;
    }

    const Template& m_asset;
    PictureArray& m_out;
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
                                                               : kSolid;
    record.unlit = choice.unlit ? 1.0F : 0.0F;
    const std::array<float, 6>& uv = choice.uvTransform;
    record.uvRowU = {uv[0], uv[1], uv[2], 1.0F};
    record.uvRowV = {uv[3], uv[4], uv[5], choice.alphaMode == AlphaMode::Blend ? 1.0F : 0.0F};
    record.emissive =
        glm::vec4(choice.emissive, static_cast<float>(layers.plain(choice.emissiveImage)));
    const std::array<float, 6>& glow = choice.emissiveUvTransform;
    record.glowRowU = {glow[0], glow[1], glow[2], choice.roughness};
    record.glowRowV = {glow[3], glow[4], glow[5], choice.metallic};
    return record;
}

float luminance(const glm::vec3& linear)
{
    return glm::dot(linear, glm::vec3(0.2126F, 0.7152F, 0.0722F));
}

const std::uint8_t* texelAt(const PictureArray& images, int layer, const glm::vec2& uv)
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
                      bool isOpaqueSlot, const PictureArray& images)
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

bool hasPicture(const MaterialChoice& choice)
{
    return choice.image >= 0 || choice.emissiveImage >= 0 || choice.tintMask >= 0;
}

/// The pictures that choices may need layers for: of base colours, masks and emissions.
using Pictures = std::set<std::tuple<int, int, int>>;

void addPictures(const Slot& slot, Pictures& pictures)
{
    for (const MaterialChoice& choice : slot.choices) {
        pictures.insert({choice.image, choice.tintMask, -1});
        pictures.insert({-1, choice.tintMask, -1});
        pictures.insert({-1, -1, choice.emissiveImage});
    }
}

Sampling samplingOf(const Slot& slot)
{
    const auto first = std::ranges::find_if(slot.choices, hasPicture);
    return {first->wrapU, first->wrapV, first->nearest, false};
}

/// An array while slots are handed out to them.
struct Planned
{
    Sampling sampling;
    Pictures pictures;
};

bool hasRoom(const Planned& planned, const Slot& slot)
{
    Pictures together = planned.pictures;
    addPictures(slot, together);
    return together.size() < kMaxLayers;
}

struct ArrayPlan
{
    std::vector<Planned> arrays;
    std::vector<int> ofSlot;
};

ArrayPlan planArrays(const Template& asset)
{
    ArrayPlan plan;
    for (const Slot& slot : asset.slots) {
        plan.ofSlot.push_back(0);
        if (std::ranges::none_of(slot.choices, hasPicture)) {
            continue;
        }
        const Sampling sampling = samplingOf(slot);
        auto at = std::ranges::find_if(plan.arrays, [&](const Planned& planned) {
            return planned.sampling == sampling && hasRoom(planned, slot);
        });
        if (at == plan.arrays.end()) {
            at = plan.arrays.insert(at, {sampling, {}});
        }
        addPictures(slot, at->pictures);
        plan.ofSlot.back() = static_cast<int>(at - plan.arrays.begin());
    }
    if (plan.arrays.empty()) {
        plan.arrays.push_back({{}, {}});
    }
    return plan;
}

/// Large enough for every picture that is coloured, and for masks and emissions where nothing is.
void chooseSize(const Template& asset, const Planned& planned, PictureArray& out)
{
    const auto fit = [&](int index) {
        if (index >= 0) {
            const Image& image = asset.images[static_cast<std::size_t>(index)];
            out.width = std::max(out.width, fittingSize(image.width));
            out.height = std::max(out.height, fittingSize(image.height));
        }
    };
    for (const auto& [image, mask, glow] : planned.pictures) {
        fit(image);
        fit(glow);
    }
    if (out.width == 1 && out.height == 1) {
        for (const auto& picture : planned.pictures) {
            fit(std::get<1>(picture));
        }
    }
    const std::size_t layers = planned.pictures.size() + 1;
    while (static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 4 * layers >
           kMaxArrayBytes) {
        out.width = std::max(out.width / 2, 1);
        out.height = std::max(out.height / 2, 1);
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

std::vector<int> arraysOfSlots(const Template& asset)
{
    return planArrays(asset).ofSlot;
}

TemplateImages templateImages(const Template& asset, int halvings)
{
    TemplateImages out;
    const ArrayPlan plan = planArrays(asset);
    out.arrays.resize(plan.arrays.size());
    std::vector<Layers> layers;
    for (std::size_t i = 0; i < plan.arrays.size(); ++i) {
        out.arrays[i].sampling = plan.arrays[i].sampling;
        chooseSize(asset, plan.arrays[i], out.arrays[i]);
        out.arrays[i].width = std::max(out.arrays[i].width >> halvings, 1);
        out.arrays[i].height = std::max(out.arrays[i].height >> halvings, 1);
        layers.emplace_back(asset, out.arrays[i]);
    }
    for (const Slot& slot : asset.slots) {
        out.choicesPerSlot = std::max(out.choicesPerSlot, static_cast<int>(slot.choices.size()));
    }
    for (std::size_t s = 0; s < asset.slots.size(); ++s) {
        const Slot& slot = asset.slots[s];
        const bool isOpaque = std::ranges::all_of(slot.choices, [](const MaterialChoice& choice) {
            return choice.alphaMode == AlphaMode::Opaque;
        });
        for (std::size_t i = 0; i < static_cast<std::size_t>(out.choicesPerSlot); ++i) {
            const MaterialChoice& choice = slot.choices[i < slot.choices.size() ? i : 0];
            const auto array = static_cast<std::size_t>(plan.ofSlot[s]);
            MaterialRecord record = recordOf(choice, slot.tintable, isOpaque, layers[array]);
            record.uvRowU.w = slot.tintable ? tintedLuminance(asset, static_cast<int>(s), record,
                                                              isOpaque, out.arrays[array])
                                            : 1.0F;
            out.materials.push_back(record);
        }
    }
    return out;
}

} // namespace crowd::render
