// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "model/base/Result.h"
#include "model/scene/Scene.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderProgram.h"
#include "render/gl/ShaderVariants.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// Draws the static geometry of a scene: a call per material of each stage.
class StagePass
{
public:
    /// Pictures halved so many times, where the card has little room.
    explicit StagePass(int halvings = 0) : m_halvings(halvings) {}
    /// Opaque and cut-out materials; blended ones follow in drawBlended().
    [[nodiscard]] model::Result<void> draw(const PassContext& context);
    [[nodiscard]] model::Result<void> drawBlended(const PassContext& context);
    /// Depth alone, of what is solid, from both sides.
    [[nodiscard]] model::Result<void> drawCasters(const PassContext& context);
    /// Depth alone, of what is solid, as draw() will find it: what is hidden costs no light then.
    [[nodiscard]] model::Result<void> drawDepths(const PassContext& context);
    [[nodiscard]] static bool areDepthsWorthwhile(const PassContext& context);
    /// Stages that the last picture did not show go at once.
    void releaseUnused();

private:
    struct Batch
    {
        int material = 0;
        std::uint32_t firstIndex = 0;
        std::uint32_t indexCount = 0;
    };
    struct Gpu
    {
        model::StagePtr asset;
        GlVertexArray array;
        GlBuffer vertices;
        GlBuffer indices;
        std::vector<Batch> batches;
        std::vector<GlTexture> textures; ///< per material; empty where it has no picture at all
        std::vector<GlTexture> glows;    ///< likewise, emissive
        std::vector<GlTexture> reliefs;  ///< of normals; empty where it has none
        int unusedFrames = 0;
    };

    [[nodiscard]] Gpu& gpuOf(const model::StagePtr& asset);
    [[nodiscard]] model::Result<void> drawEntries(const PassContext& context, bool isBlended);
    [[nodiscard]] model::Result<void> drawBatch(const PassContext& context, const Gpu& gpu,
                                                const Batch& batch, const glm::mat4& matrix);
    [[nodiscard]] model::Result<void> drawSolids(const PassContext& context, bool fromBothSides);
    [[nodiscard]] model::Result<void> drawCaster(const PassContext& context, const Gpu& gpu,
                                                 const Batch& batch, const glm::mat4& matrix);
    static void setRelief(ShaderProgram& shader, const Gpu& gpu, std::size_t index);
    static void setSurface(ShaderProgram& shader, const Gpu& gpu, std::size_t index);

    int m_halvings;
    std::map<const model::StageAsset*, std::unique_ptr<Gpu>> m_gpu;
    ShaderVariants m_programs{"stage"};
};

} // namespace crowd::render
