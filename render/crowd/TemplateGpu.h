// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/bake/DrawLevels.h"
#include "model/bake/KeyframeStore.h"
#include "render/crowd/CrowdPlan.h"
#include "render/crowd/ImpostorGpu.h"
#include "render/crowd/MeshGroups.h"
#include "render/gl/GlObjects.h"

namespace crowd::render {

/// A template on the graphics card: triangles and static vertex data per level, the keyframes that
/// were asked for so far, its pictures in arrays, its materials in a table.
class TemplateGpu
{
public:
    /// Reduced where the card has little room: without so many of its finest levels, pictures
    /// halved so many times.
    explicit TemplateGpu(model::TemplatePtr asset, int reduction = 0);

    /// Asks the store for a clip and uploads what is new of it.
    void useClip(model::KeyframeStore& store, int clipIndex);

    /// Asks for cards of a clip that somebody would be drawn with.
    void wantImpostors(model::KeyframeStore& store, int clipIndex, int band);
    /// Sends those that are ready.
    void takeImpostors(model::KeyframeStore& store);
    [[nodiscard]] const ImpostorGpu& impostors() const { return m_impostors; }

    [[nodiscard]] const model::TemplatePtr& asset() const { return m_asset; }
    /// One per clip of the asset; unused ones have no bounds.
    [[nodiscard]] const std::vector<PlanClip>& clips() const { return m_clips; }
    [[nodiscard]] int levelCount() const { return static_cast<int>(m_levels.size()); }
    /// Radius of the soft shadow at girth 1, metres.
    [[nodiscard]] float shadowRadius() const { return m_shadowRadius; }

    struct Level
    {
        std::vector<MeshGroup> groups;
        GlVertexArray array; ///< static attributes and indices; instance attributes are the user's
        GlBuffer vertices;
        GlBuffer indices;
        int vertexLevel = 0;
        std::uint32_t verticesPerKeyframe = 0;
        bool isBlended = false; ///< some group is
    };
    /// Or the finest there is.
    [[nodiscard]] const Level& level(int index) const
    {
        return m_levels[static_cast<std::size_t>(std::max(index, m_finest))];
    }
    /// Binds keyframes (of a level), clip boxes and materials to texture units from `first`.
    void bindTables(int levelIndex, int first) const;
    /// Binds an array of TemplateImages::arrays.
    void bindPictures(int array, int unit) const;
    /// Along a side of a picture.
    [[nodiscard]] float pictureTexels() const { return m_pictureTexels; }
    [[nodiscard]] int choicesPerSlot() const { return m_choicesPerSlot; }
    [[nodiscard]] std::uint32_t tintableSlots() const { return m_tintableSlots; }

private:
    void makeLevels(int reduction);
    void makeMaterials(int reduction);
    [[nodiscard]] bool isSent(std::size_t vertexLevel) const;
    void append(int clipIndex, const model::KeyframeStore::Entry& entry);

    model::TemplatePtr m_asset;
    std::vector<PlanClip> m_clips;
    std::vector<model::BakedClipPtr> m_uploaded; ///< per clip, what its PlanClip refers to
    std::vector<Level> m_levels;                 ///< those before the finest are empty
    int m_finest = 0;
    std::vector<TexelBuffer> m_keyframes; ///< per level of the asset
    ImpostorGpu m_impostors;
    TexelBuffer m_boxes;
    TexelBuffer m_materials;
    std::vector<GlTexture> m_pictures; ///< one per array
    float m_pictureTexels = 1.0F;      ///< of a side
    std::uint32_t m_keyframeCount = 0; ///< uploaded so far
    std::uint16_t m_boxCount = 0;
    int m_choicesPerSlot = 1;
    std::uint32_t m_tintableSlots = 0;
    float m_shadowRadius = 0.0F;
};

} // namespace crowd::render
