// SPDX-License-Identifier: MIT
#include "render/crowd/MeshGroups.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "render/crowd/TemplateImages.h"

namespace crowd::render {

namespace {

using namespace model;

bool isSpecial(const MaterialChoice& choice)
{
    return choice.unlit || choice.emissive != glm::vec3(0.0F);
}

/// Opaque before cut-out before blended; then whatever keeps state changes few.
bool drawsBefore(const GroupState& a, const GroupState& b)
{
    return std::tie(a.alphaMode, a) < std::tie(b.alphaMode, b);
}

class Builder
{
public:
    Builder(const Template& asset, const DrawLevel& level)
        : m_mesh(asset.levels[static_cast<std::size_t>(level.vertexLevel)]), m_level(level)
    {
    }

    void add(const Submesh& submesh, GroupedMesh& out)
    {
        const auto slot = static_cast<std::uint16_t>(std::min(submesh.slot, 65535));
        const auto part = static_cast<std::uint16_t>(submesh.part < 0 ? 255 : submesh.part);
        for (std::uint32_t i = 0; i < submesh.indexCount; ++i) {
            const std::uint32_t source = m_level.indices[submesh.firstIndex + i];
            out.indices.push_back(vertexFor(source, slot, part, out));
        }
    }

private:
    std::uint32_t vertexFor(std::uint32_t source, std::uint16_t slot, std::uint16_t part,
                            GroupedMesh& out)
    {
        const auto next = static_cast<std::uint32_t>(out.vertices.size());
        const auto [found, isNew] = m_made.try_emplace({source, slot, part}, next);
        if (isNew) {
            StaticVertex vertex;
            vertex.source = source;
            vertex.slot = slot;
            vertex.part = part;
            if (source < m_mesh.uv.size()) {
                vertex.uv = m_mesh.uv[source];
            }
            if (source < m_mesh.colors.size()) {
                vertex.color = m_mesh.colors[source];
            }
            out.vertices.push_back(vertex);
        }
        return found->second;
    }

    const Mesh& m_mesh;
    const DrawLevel& m_level;
    std::map<std::tuple<std::uint32_t, std::uint16_t, std::uint16_t>, std::uint32_t> m_made;
};

} // namespace

GroupState groupStateOf(const Slot& slot, int pictures)
{
    GroupState state;
    for (const MaterialChoice& choice : slot.choices) {
        const bool isMasked = choice.tintMask >= 0 && slot.tintable;
        state.isTextured = state.isTextured || choice.image >= 0 || isMasked;
        state.isMasked = state.isMasked || isMasked;
        state.isDoubleSided = state.isDoubleSided || choice.doubleSided;
        state.isSpecial = state.isSpecial || isSpecial(choice);
        state.isGlowing = state.isGlowing || choice.emissiveImage >= 0;
        state.alphaMode = std::max(state.alphaMode, choice.alphaMode);
    }
    state.pictures = state.isTextured || state.isGlowing ? pictures : 0;
    return state;
}

std::string definesOf(const GroupState& state, Surface surface)
{
    std::string defines;
    const auto define = [&defines](bool isOn, const char* word) {
        if (isOn) {
            defines += word;
            defines += ' ';
        }
    };
    const bool hasAlpha = state.alphaMode != AlphaMode::Opaque;
    if (surface == Surface::Caster && !hasAlpha) {
        return "CASTER ";
    }
    define(surface == Surface::Caster, "CASTER");
    define(state.isTextured, "TEXTURED");
    define(state.isMasked, "TINT_IN_TEXTURE");
    define(state.isTextured && hasAlpha, "SEPARATE_MASK");
    define(state.isSpecial, "SPECIAL");
    define(state.isGlowing, "GLOWING");
    define(hasAlpha, "CUTOUT");
    define(surface == Surface::SeeThrough, "BLENDED");
    return defines;
}

GroupedMesh groupMesh(const Template& asset, const DrawLevel& level)
{
    std::vector<std::pair<GroupState, Submesh>> ordered;
    const std::vector<int> arrays = arraysOfSlots(asset);
    for (const Submesh& submesh : level.submeshes) {
        const auto slot = static_cast<std::size_t>(submesh.slot);
        ordered.emplace_back(groupStateOf(asset.slots[slot], arrays[slot]), submesh);
    }
    std::ranges::stable_sort(
        ordered, [](const auto& a, const auto& b) { return drawsBefore(a.first, b.first); });
    GroupedMesh out;
    Builder builder(asset, level);
    for (const auto& [state, submesh] : ordered) {
        if (out.groups.empty() || out.groups.back().state != state) {
            out.groups.push_back({state, static_cast<std::uint32_t>(out.indices.size()), 0});
        }
        builder.add(submesh, out);
        out.groups.back().indexCount += submesh.indexCount;
    }
    return out;
}

} // namespace crowd::render
