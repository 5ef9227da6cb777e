// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "render/RenderInput.h"
#include "render/crowd/CrowdPlan.h"
#include "render/crowd/StaticRecords.h"
#include "render/crowd/TemplateGpu.h"
#include "render/gl/GlObjects.h"

namespace crowd::render {

/// Static records of rows on the graphics card: of the population, or of a ghost.
struct CrowdRows
{
    CrowdRows();
    void begin(); ///< so that they can be bound while nobody is there
    TexelBuffer placement;
    TexelBuffer appearance;
};

/// What is kept of the whole crowd, on the graphics card and for planning, whoever looks at it:
/// templates with the clips that somebody is in, and where and how everybody is. Brought up to date
/// once a frame; then each CrowdView is made from it.
class CrowdGpu
{
public:
    /// Reduced as TemplateGpu says.
    explicit CrowdGpu(int reduction = 0) : m_reduction(reduction) {}
    void initialize();
    /// Of the frame; without one, time passes for what is not used.
    void update(const RenderInput& input);
    /// Has the clips of another moment of the same people as well, until the next update. False: it
    /// is of other templates.
    [[nodiscard]] bool useAlso(const RenderInput& input);
    /// Asks for some of the cards that a view would have drawn, so that the frame does not wait;
    /// they are there in one of the next ones.
    void want(std::span<const WantedImpostors> wanted, model::KeyframeStore& store);
    /// Sends what changed.
    void upload(RenderStatistics& statistics);
    /// Templates that the last picture did not mention go at once.
    void releaseUnused();

    [[nodiscard]] TemplateGpu& gpuOf(const model::TemplatePtr& asset);
    /// By index into the frame's templates.
    [[nodiscard]] TemplateGpu& gpuOf(int entry);
    [[nodiscard]] const model::TemplatePtr& asset(int entry) const
    {
        return (*m_entries)[static_cast<std::size_t>(entry)].asset;
    }
    /// One per template of the frame.
    [[nodiscard]] std::span<const PlanTemplate> templates() const { return m_planTemplates; }
    [[nodiscard]] std::span<const RecordTemplate> recordTemplates() const
    {
        return m_recordTemplates;
    }
    [[nodiscard]] std::uint64_t templatesVersion() const { return m_templatesVersion; }
    [[nodiscard]] const StaticRecords& records() const { return m_records; }
    [[nodiscard]] const CrowdRows& rows() const { return m_rows; }

private:
    void countUnused();
    void dropUnused(int frames);
    void refreshTemplates(const RenderInput& input);
    void findUsedClips(const model::Population& people);
    void useFadedClips(const RenderInput& input);
    void useShownClips(const RenderInput& input);

    int m_reduction;
    std::map<const model::Template*, std::unique_ptr<TemplateGpu>> m_gpu;
    std::map<const model::Template*, int> m_unusedFrames;
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
    CrowdRows m_rows;
};

} // namespace crowd::render
