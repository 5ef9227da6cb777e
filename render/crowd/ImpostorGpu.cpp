// SPDX-License-Identifier: MIT
#include "render/crowd/ImpostorGpu.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "render/crowd/TemplateImages.h"

namespace crowd::render {

namespace {

using namespace model;

/// Four RGBA32UI texels, so that small whole numbers come through as they are; as in impostor.vert.
struct SetRecord
{
    glm::vec4 card{0.0F};     ///< low, size: metres
    float middle = 0.0F;      ///< metres
    float nearest = 0.0F;     ///< metres
    float depth = 0.0F;       ///< metres
    float sine = 0.0F;        ///< of the band's angle
    float cosine = 1.0F;      ///< of it
    std::uint32_t width = 0;  ///< texels
    std::uint32_t height = 0; ///< texels
    std::uint32_t layers = 1;
    std::uint32_t firstCard = 0;
    std::array<std::uint32_t, 3> unused{};
};
static_assert(sizeof(SetRecord) == 64);

/// An RGBA32UI texel; as in impostor.vert.
struct CardRecord
{
    glm::u8vec4 shown{0};
    std::uint32_t first = 0; ///< texel
    std::uint16_t deep = 0;  ///< of the plane in the card's middle, as texels say it, but finer
    std::int16_t right = 0;  ///< its slopes: kSlope is one
    std::int16_t up = 0;
    std::uint16_t unused = 0;
};
static_assert(sizeof(CardRecord) == 16);

CardRecord recordOf(const ImpostorCard& card, const ImpostorLayout& layout, std::size_t first)
{
    constexpr float kSlope = 8192.0F;
    constexpr float kFinest = 65535.0F;
    CardRecord record;
    record.shown = card.shown;
    record.first = static_cast<std::uint32_t>(first) + card.first;
    const float share = std::clamp((layout.nearest - card.plane.x) / layout.depth, 0.0F, 1.0F);
    record.deep = static_cast<std::uint16_t>(std::lround(share * kFinest));
    record.right = static_cast<std::int16_t>(std::lround(card.plane.y * kSlope));
    record.up = static_cast<std::int16_t>(std::lround(card.plane.z * kSlope));
    return record;
}

SetRecord recordOf(const ImpostorSet& set, std::size_t firstCard)
{
    const ImpostorLayout& layout = set.layout;
    const float above = kImpostorBands[static_cast<std::size_t>(set.band)].radians;
    SetRecord record;
    record.card = glm::vec4(layout.low, layout.size);
    record.middle = layout.middle;
    record.nearest = layout.nearest;
    record.depth = layout.depth;
    record.sine = std::sin(above);
    record.cosine = std::cos(above);
    record.width = static_cast<std::uint32_t>(layout.texels.x);
    record.height = static_cast<std::uint32_t>(layout.texels.y);
    record.layers = static_cast<std::uint32_t>(layout.layers);
    record.firstCard = static_cast<std::uint32_t>(firstCard);
    return record;
}

/// As one group of triangles of them all would have it.
GroupState joined(const Template& asset, std::span<const int> arrays)
{
    GroupState all;
    for (std::size_t i = 0; i < asset.slots.size(); ++i) {
        const GroupState one = groupStateOf(asset.slots[i], arrays[i]);
        all.isTextured = all.isTextured || one.isTextured;
        all.isMasked = all.isMasked || one.isMasked;
        all.isSpecial = all.isSpecial || one.isSpecial;
        all.isGlowing = all.isGlowing || one.isGlowing;
        all.pictures = one.isTextured || one.isGlowing ? one.pictures : all.pictures;
    }
    return all;
}

bool areInOneArray(const Template& asset, std::span<const int> arrays, int array)
{
    for (std::size_t i = 0; i < asset.slots.size(); ++i) {
        const GroupState one = groupStateOf(asset.slots[i], arrays[i]);
        if ((one.isTextured || one.isGlowing) && one.pictures != array) {
            return false;
        }
    }
    return true;
}

/// Whether some lie elsewhere than their coordinates say.
bool movesPictures(const Template& asset)
{
    const std::array<float, 6> unmoved = MaterialChoice().uvTransform;
    return std::ranges::any_of(asset.slots, [&](const Slot& slot) {
        return std::ranges::any_of(slot.choices, [&](const MaterialChoice& choice) {
            return choice.uvTransform != unmoved;
        });
    });
}

/// On average over the surface.
float sharePerMetre(const Mesh& mesh)
{
    double surface = 0.0;
    double picture = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size() && !mesh.uv.empty(); i += 3) {
        const std::uint32_t* corner = &mesh.indices[i];
        const glm::vec3 a = mesh.positions[corner[1]] - mesh.positions[corner[0]];
        const glm::vec3 b = mesh.positions[corner[2]] - mesh.positions[corner[0]];
        const glm::vec2 u = mesh.uv[corner[1]] - mesh.uv[corner[0]];
        const glm::vec2 v = mesh.uv[corner[2]] - mesh.uv[corner[0]];
        surface += static_cast<double>(glm::length(glm::cross(a, b)));
        picture += static_cast<double>(std::abs(u.x * v.y - u.y * v.x));
    }
    return surface > 0.0 ? static_cast<float>(std::sqrt(picture / surface)) : 0.0F;
}

} // namespace

ImpostorGpu::ImpostorGpu(const Template& asset)
    : m_texels(GL_RG32UI), m_sets(GL_RGBA32UI), m_cards(GL_RGBA32UI)
{
    if (!canHaveImpostors(asset)) {
        return;
    }
    const std::vector<int> arrays = arraysOfSlots(asset);
    m_state = joined(asset, arrays);
    m_arePossible = areInOneArray(asset, arrays, m_state.pictures);
    m_sharePerMetre = sharePerMetre(asset.levels.front());
    m_defines = asset.parts.empty() ? "" : "PARTS ";
    m_defines += movesPictures(asset) ? "PICTURES_MOVED " : "";
    m_array = GlVertexArray::create();
}

PlanImpostors ImpostorGpu::send(const ImpostorSet& set)
{
    PlanImpostors plan;
    plan.layout = set.layout;
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    plan.isNone =
        set.layout.isEmpty() || m_texelCount + set.texels.size() > static_cast<std::size_t>(most);
    if (plan.isNone) {
        return plan;
    }
    const auto bytes = std::as_bytes(std::span(set.texels));
    m_texels.reserve(m_texelCount * sizeof(ImpostorTexel) + bytes.size());
    m_texels.write(m_texelCount * sizeof(ImpostorTexel), bytes);
    const std::array<SetRecord, 1> record{recordOf(set, m_cardCount)};
    m_sets.reserve((m_setCount + std::size_t{1}) * sizeof(SetRecord));
    m_sets.write(m_setCount * sizeof(SetRecord), std::as_bytes(std::span(record)));
    plan.isThere = true;
    plan.set = m_setCount++;
    std::vector<CardRecord> records(set.cards.size());
    std::ranges::transform(set.cards, records.begin(), [&](const ImpostorCard& card) {
        return recordOf(card, set.layout, m_texelCount);
    });
    m_cards.reserve((m_cardCount + records.size()) * sizeof(CardRecord));
    m_cards.write(m_cardCount * sizeof(CardRecord), std::as_bytes(std::span(records)));
    m_cardCount += records.size();
    m_texelCount += set.texels.size();
    return plan;
}

void ImpostorGpu::take(KeyframeStore& store, const TemplatePtr& asset,
                       std::span<const BakedClipPtr> complete, std::vector<PlanClip>& clips)
{
    std::erase_if(m_wanted, [&](const std::pair<int, int>& wanted) {
        const auto clip = static_cast<std::size_t>(wanted.first);
        if (!complete[clip]) {
            return false;
        }
        const ImpostorSetPtr set =
            store.impostors(asset, wanted.first, complete[clip], wanted.second);
        if (set) {
            clips[clip].impostors[static_cast<std::size_t>(wanted.second)] = send(*set);
        }
        return set != nullptr;
    });
}

void ImpostorGpu::bind(int texels, int sets, int cards) const
{
    m_texels.bind(texels);
    m_sets.bind(sets);
    m_cards.bind(cards);
}

} // namespace crowd::render
