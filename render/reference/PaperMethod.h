// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "model/base/Result.h"
#include "render/RenderInput.h"
#include "render/gl/GlObjects.h"
#include "render/gl/PictureTarget.h"

namespace crowd::render {

/// How the first crowd brush drew its people (Ulicny, de Heras Ciechomski, Thalmann 2004): each
/// keyframe of each submesh in a display list of its own, individuals sorted by template, material
/// and keyframe, fixed-function light. What our drawing is measured against; needs a compatibility
/// context, current in every call. Draws the same scene with the same anti-aliasing as Renderer, at
/// full detail, nearest keyframe, without shadows and grid.
class PaperMethod
{
public:
    [[nodiscard]] model::Result<void> draw(const RenderInput& input);
    [[nodiscard]] std::vector<std::uint8_t> readPixels() const { return m_target.read(); }
    /// Display lists called for the last picture.
    [[nodiscard]] int calls() const { return m_calls; }
    void destroy();

private:
    struct Asset
    {
        model::TemplatePtr asset;
        std::vector<std::vector<std::uint32_t>> lists; ///< per clip: keyframes × submeshes
        std::vector<GlTexture> textures;               ///< per image
    };
    /// A submesh of an individual, before sorting.
    struct Call
    {
        std::uint64_t key = 0; ///< template, submesh, material, keyframe
        std::uint32_t row = 0;
        std::uint32_t list = 0;
    };

    [[nodiscard]] Asset& assetOf(const model::TemplatePtr& asset);
    [[nodiscard]] std::uint32_t listOf(Asset& asset, int clip, int keyframe, std::size_t submesh);
    void makeClipLists(Asset& asset, int clip);
    void collect(const RenderInput& input);
    void setUp(const RenderInput& input) const;
    void drawPeople(const RenderInput& input);
    void drawStages(const RenderInput& input);
    void drawBackground(const RenderInput& input) const;

    PictureTarget m_target;
    std::map<const model::Template*, Asset> m_assets;
    std::map<const model::StageAsset*, std::vector<std::uint32_t>> m_stageLists;
    std::map<const model::StageAsset*, std::vector<GlTexture>> m_stageTextures;
    std::vector<Call> m_people;
    int m_calls = 0;
};

} // namespace crowd::render
