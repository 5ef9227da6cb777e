// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/bake/KeyframeStore.h"
#include "render/crowd/CrowdPlan.h"
#include "render/crowd/MeshGroups.h"
#include "render/gl/GlObjects.h"

namespace crowd::render {

/// The cards of a template on the graphics card, those that somebody wanted so far.
class ImpostorGpu
{
public:
    explicit ImpostorGpu(const model::Template& asset);

    /// Whether the template can have any: its pictures lie in one array.
    [[nodiscard]] bool arePossible() const { return m_arePossible; }
    /// Asks for the cards of a clip in a band, from now on.
    void want(int clip, int band) { m_wanted.insert({clip, band}); }
    [[nodiscard]] bool isAnyWanted() const { return !m_wanted.empty(); }
    /// Sends what is ready of what is wanted; the clips are the template's. `complete`: by clip,
    /// null where it is not.
    void take(model::KeyframeStore& store, const model::TemplatePtr& asset,
              std::span<const model::BakedClipPtr> complete, std::vector<PlanClip>& clips);

    /// Binds texels, the table of sets and that of cards to texture units.
    void bind(int texels, int sets, int cards) const;
    /// Of all slots: for the shader that draws any of them.
    [[nodiscard]] const GroupState& state() const { return m_state; }
    /// Words for the shader beside those of the state.
    [[nodiscard]] const std::string& defines() const { return m_defines; }
    /// Width of a piece of a picture that covers a metre, as a share of the picture.
    [[nodiscard]] float pictureSharePerMetre() const { return m_sharePerMetre; }
    [[nodiscard]] const GlVertexArray& array() const { return m_array; }

private:
    [[nodiscard]] PlanImpostors send(const model::ImpostorSet& set);

    GroupState m_state;
    std::string m_defines;
    bool m_arePossible = false;
    float m_sharePerMetre = 0.0F;
    std::set<std::pair<int, int>> m_wanted; ///< clip and band; not sent yet
    TexelBuffer m_texels;
    TexelBuffer m_sets;
    TexelBuffer m_cards;          ///< ImpostorSet::cards
    std::size_t m_texelCount = 0; ///< sent
    std::size_t m_cardCount = 0;
    std::uint32_t m_setCount = 0;
    GlVertexArray m_array;
};

} // namespace crowd::render
