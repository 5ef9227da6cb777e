// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/base/Result.h"
#include "render/crowd/CrowdPlan.h"
#include "render/crowd/StaticRecords.h"
#include "render/crowd/TemplateGpu.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderProgram.h"
#include "render/passes/OutlinePass.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// Draws all individuals of a frame, the shadows that go with them, and ghosts. Who is highlighted
/// is left in the alpha of the picture, for OutlinePass.
/// Order of calls per picture: prepare, drawPeople, then (after the stage) drawShadows,
/// drawSeeThrough, drawGhosts.
class CrowdPass
{
public:
    CrowdPass();

    [[nodiscard]] model::Result<void> initialize();
    /// Records, plan and uploads.
    [[nodiscard]] model::Result<void> prepare(const PassContext& context);
    [[nodiscard]] model::Result<void> drawPeople(const PassContext& context);
    void drawShadows(const PassContext& context);
    /// What of people is blended over what is behind them: farthest first.
    [[nodiscard]] model::Result<void> drawSeeThrough(const PassContext& context);
    [[nodiscard]] model::Result<void> drawGhosts(const PassContext& context);
    /// Whether somebody in the picture is selected or hovered.
    [[nodiscard]] bool hasHighlighted() const { return !m_plan.highlighted().empty(); }
    /// What they cover, generously.
    [[nodiscard]] PixelRect highlightedPart(const PassContext& context) const;
    /// Templates that the last picture did not mention go at once.
    void releaseUnused();

private:
    /// Per-row buffers: of the population, or of the ghosts.
    struct RowBuffers
    {
        RowBuffers();
        TexelBuffer placement;
        TexelBuffer appearance;
        GlBuffer instances;
    };
    struct Drawing
    {
        const RowBuffers& rows;
        const GlBuffer& instances;
        std::string defines; ///< added to those of the group
        float opacity = 1.0F;
        Surface surface = Surface::Solid;
    };

    [[nodiscard]] TemplateGpu& gpuOf(const model::TemplatePtr& asset);
    void countUnused();
    void dropUnused(int frames);
    void refreshTemplates(const PassContext& context);
    void findUsedClips(const model::Population& people);
    void useFadedClips(const PassContext& context);
    void useShownClips(const PassContext& context);
    void uploadRecords(const PassContext& context);
    void uploadInstances(GlBuffer& buffer, std::span<const Instance> instances) const;
    [[nodiscard]] model::Result<ShaderProgram*> program(const std::string& defines);
    [[nodiscard]] model::Result<void> drawRun(const PassContext& context, const Drawing& drawing,
                                              const TemplateGpu& gpu, const InstanceRun& run);
    [[nodiscard]] model::Result<void> drawGhost(const PassContext& context, const Ghost& ghost);
    void setUniforms(const PassContext& context, const Drawing& drawing, const TemplateGpu& gpu,
                     std::uint32_t verticesPerKeyframe, ShaderProgram& shader) const;
    void drawGroup(const PassContext& context, const MeshGroup& group,
                   const InstanceRun& run) const;
    void collectSeeThrough(const PassContext& context);

    std::map<const model::Template*, std::unique_ptr<TemplateGpu>> m_gpu;
    std::map<const model::Template*, int> m_unusedFrames;
    std::map<std::string, ShaderProgram> m_programs;
    ShaderProgram m_blobProgram;
    GlVertexArray m_blobArray;
    GlBuffer m_blobCorners;

    std::shared_ptr<const std::vector<model::TemplateEntry>>
        m_entries; ///< that the next two mirror
    std::uint64_t m_templatesVersion = 0;
    std::vector<PlanTemplate> m_planTemplates;
    std::vector<RecordTemplate> m_recordTemplates;
    struct UsedClip
    {
        std::size_t entry; ///< index into m_entries
        std::uint16_t clip;
    };
    std::vector<UsedClip> m_usedClips;
    std::uint64_t m_usedVersion = 0; ///< of the population that m_usedClips tells of
    std::uint64_t m_usedTemplatesVersion = 0;
    StaticRecords m_records;
    CrowdPlan m_plan;
    RowBuffers m_rows;
    RowBuffers m_ghostRows;
    std::vector<Instance> m_seeThrough; ///< farthest first
    std::vector<InstanceRun> m_seeThroughRuns;
    GlBuffer m_seeThroughInstances;
};

} // namespace crowd::render
