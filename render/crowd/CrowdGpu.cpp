// SPDX-License-Identifier: MIT
#include "render/crowd/CrowdGpu.h"

#include <algorithm>
#include <set>
#include <utility>

#include <epoxy/gl.h>

namespace crowd::render {

namespace {

using namespace model;

constexpr int kFramesBeforeDropping = 600;
/// Impostors asked for in a frame: laying each out takes half a millisecond.
constexpr std::size_t kMostWanted = 8;
/// Cards save time, and take room that triangles need more where there is little.
constexpr int kMostWithImpostors = 1;

/// How many rows were written.
template<class Record>
std::size_t writeRows(TexelBuffer& buffer, std::span<const Record> records,
                      std::span<const RowRange> ranges)
{
    std::size_t rows = 0;
    for (const RowRange& range : ranges) {
        buffer.write(range.first * sizeof(Record),
                     std::as_bytes(records.subspan(range.first, range.count)));
        rows += range.count;
    }
    return rows;
}

} // namespace

CrowdRows::CrowdRows() : placement(GL_RGBA32F), appearance(GL_RGBA32UI) {}

void CrowdRows::begin()
{
    placement.reserve(sizeof(PlacementRecord));
    appearance.reserve(sizeof(AppearanceRecord));
}

void CrowdGpu::initialize()
{
    m_rows.begin();
}

TemplateGpu& CrowdGpu::gpuOf(const TemplatePtr& asset)
{
    std::unique_ptr<TemplateGpu>& gpu = m_gpu[asset.get()];
    if (!gpu) {
        gpu = std::make_unique<TemplateGpu>(asset, m_reduction);
    }
    m_unusedFrames[asset.get()] = 0;
    return *gpu;
}

void CrowdGpu::countUnused()
{
    if (m_entries) {
        for (const TemplateEntry& entry : *m_entries) {
            m_unusedFrames[entry.asset.get()] = 0;
        }
    }
    for (auto& [asset, frames] : m_unusedFrames) {
        ++frames;
    }
}

void CrowdGpu::dropUnused(int frames)
{
    std::erase_if(m_unusedFrames, [&](const auto& item) {
        const bool isDropped = item.second > frames;
        if (isDropped) {
            m_gpu.erase(item.first);
        }
        return isDropped;
    });
}

void CrowdGpu::releaseUnused()
{
    dropUnused(0);
}

TemplateGpu& CrowdGpu::gpuOf(int entry)
{
    return gpuOf(asset(entry));
}

void CrowdGpu::refreshTemplates(const RenderInput& input)
{
    const auto& entries = input.frame->templates;
    if (entries == m_entries) {
        return;
    }
    m_entries = entries;
    ++m_templatesVersion;
    m_planTemplates.assign(entries->size(), {});
    m_recordTemplates.assign(entries->size(), {});
    for (std::size_t i = 0; i < entries->size(); ++i) {
        const TemplateEntry& entry = (*entries)[i];
        if (!entry.asset || entry.asset->levels.empty()) {
            continue;
        }
        const TemplateGpu& gpu = gpuOf(entry.asset);
        PlanTemplate& plan = m_planTemplates[i];
        RecordTemplate& record = m_recordTemplates[i];
        for (const std::string& name : entry.clipNames) {
            const int found = entry.asset->clipIndex(name);
            plan.clipOfName.push_back(
                static_cast<std::uint16_t>(found >= 0 ? found : entry.asset->defaultClip));
        }
        if (plan.clipOfName.empty()) {
            plan.clipOfName.push_back(static_cast<std::uint16_t>(entry.asset->defaultClip));
        }
        for (const std::uint16_t clip : plan.clipOfName) {
            record.clipOfName.push_back(&entry.asset->clips[clip]);
        }
        record.shadowRadius = gpu.shadowRadius();
        plan.height = entry.asset->height;
        plan.levels = gpu.levelCount();
        plan.hasImpostors = gpu.impostors().arePossible() && m_reduction <= kMostWithImpostors;
        plan.isDrawable = true;
    }
}

/// Finds out, when somebody changed, which clips somebody is in.
void CrowdGpu::findUsedClips(const Population& people)
{
    if (people.version() == m_usedVersion && m_usedTemplatesVersion == m_templatesVersion) {
        return;
    }
    m_usedVersion = people.version();
    m_usedTemplatesVersion = m_templatesVersion;
    /// Of a template id, in a list of all clips; the first item is for ids without a template.
    struct Names
    {
        std::uint32_t first = 0;
        std::uint32_t last = 0; ///< offset
    };
    std::vector<Names> namesOfId(std::size_t{1} << 16U);
    std::vector<std::uint8_t> isUsed(1);
    for (std::size_t i = 0; i < m_planTemplates.size(); ++i) {
        const std::size_t names = m_planTemplates[i].clipOfName.size();
        if (names > 0) {
            namesOfId[(*m_entries)[i].id] = {static_cast<std::uint32_t>(isUsed.size()),
                                             static_cast<std::uint32_t>(names - 1)};
            isUsed.resize(isUsed.size() + names);
        }
    }
    const std::span<const TemplateId> templates = people.column(columns::templateId);
    const std::span<const std::uint16_t> clips = people.column(columns::clip);
    for (std::size_t row = 0; row < templates.size(); ++row) {
        const Names names = namesOfId[templates[row]];
        isUsed[names.first + std::min<std::uint32_t>(clips[row], names.last)] = 1;
    }
    m_usedClips.clear();
    for (std::size_t i = 0; i < m_planTemplates.size(); ++i) {
        const std::vector<std::uint16_t>& clipOfName = m_planTemplates[i].clipOfName;
        for (std::size_t name = 0; name < clipOfName.size(); ++name) {
            if (isUsed[namesOfId[(*m_entries)[i].id].first + name] != 0) {
                m_usedClips.push_back({i, clipOfName[name]});
            }
        }
    }
}

/// The clips that people come from; some of them nobody else may be in.
void CrowdGpu::useFadedClips(const RenderInput& input)
{
    const CrowdFrame& frame = *input.frame;
    if (frame.fades.empty()) {
        return;
    }
    const std::span<const TemplateId> templates = frame.population.column(columns::templateId);
    std::set<std::pair<TemplateId, std::uint16_t>> faded;
    for (const ClipFade& fade : frame.fades) {
        faded.emplace(templates[fade.row], fade.clip);
    }
    for (const auto& [id, name] : faded) {
        const auto entry = std::ranges::find(*m_entries, id, &TemplateEntry::id);
        const auto index = static_cast<std::size_t>(entry - m_entries->begin());
        if (entry == m_entries->end() || !m_planTemplates[index].isDrawable) {
            continue;
        }
        const std::vector<std::uint16_t>& clips = m_planTemplates[index].clipOfName;
        const std::size_t clip = std::min<std::size_t>(name, clips.size() - 1);
        gpuOf(entry->asset).useClip(input.keyframes, clips[clip]);
    }
}

/// Asks for the clips that somebody is in or comes from; others are not baked.
void CrowdGpu::useShownClips(const RenderInput& input)
{
    findUsedClips(input.frame->population);
    for (const UsedClip& used : m_usedClips) {
        gpuOf((*m_entries)[used.entry].asset).useClip(input.keyframes, used.clip);
    }
    useFadedClips(input);
    for (std::size_t i = 0; i < m_planTemplates.size(); ++i) {
        if (m_planTemplates[i].isDrawable) {
            TemplateGpu& gpu = gpuOf((*m_entries)[i].asset);
            gpu.takeImpostors(input.keyframes);
            m_planTemplates[i].clips = gpu.clips();
        }
    }
}

void CrowdGpu::update(const RenderInput& input)
{
    countUnused();
    dropUnused(kFramesBeforeDropping); // after a while: ghosts come back often
    if (!input.frame) {
        return;
    }
    refreshTemplates(input);
    useShownClips(input);
    m_records.update(
        {*input.frame, m_recordTemplates, input.seats, input.seatsVersion, m_templatesVersion});
}

bool CrowdGpu::useAlso(const RenderInput& input)
{
    const auto isSame = [](const TemplateEntry& a, const TemplateEntry& b) {
        return a.id == b.id && a.asset == b.asset && a.clipNames == b.clipNames;
    };
    if (!std::ranges::equal(*input.frame->templates, *m_entries, isSame)) {
        return false;
    }
    useShownClips(input);
    return true;
}

void CrowdGpu::want(std::span<const WantedImpostors> wanted, KeyframeStore& store)
{
    for (const WantedImpostors& one : wanted.first(std::min(wanted.size(), kMostWanted))) {
        gpuOf(one.entry).wantImpostors(store, one.clip, one.band);
    }
}

void CrowdGpu::upload(RenderStatistics& statistics)
{
    const std::span<const PlacementRecord> placements = m_records.placements();
    const std::span<const AppearanceRecord> appearances = m_records.appearances();
    m_rows.placement.reserve(placements.size_bytes());
    m_rows.appearance.reserve(appearances.size_bytes());
    const std::size_t moved =
        writeRows(m_rows.placement, placements, m_records.changedPlacements());
    const std::size_t restyled =
        writeRows(m_rows.appearance, appearances, m_records.changedAppearances());
    statistics.uploadedPlacements = static_cast<int>(moved);
    statistics.uploadedAppearances = static_cast<int>(restyled);
    statistics.uploadedBytes = static_cast<std::int64_t>(moved * sizeof(PlacementRecord) +
                                                         restyled * sizeof(AppearanceRecord));
}

} // namespace crowd::render
