// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "model/document/FirstTouch.h"
#include "model/document/SceneDelta.h"

namespace crowd::model {

/// What an edit must remember to become a delta: ids that it added, rows that it removed, and
/// first-touch values of everything else. Each function is called just before the scene changes.
class EditRecord
{
public:
    explicit EditRecord(IndividualId nextId) : m_nextIdBefore(nextId) {}

    /// ids ascend and come after all that were ever added.
    void addIndividuals(std::span<const IndividualId> ids);
    void removeIndividuals(std::span<const IndividualId> ids, const Population& population);
    void touchColumn(ColumnId column, std::span<const IndividualId> ids,
                     const Population& population);
    void touchTemplate(TemplateId id, const Scene& scene);
    void touchStage(std::uint8_t id, const Scene& scene);
    void touchCameras(const Scene& scene);
    void touchLighting(const Scene& scene);
    void touchPlace(PlaceId id, const Scene& scene);
    void touchPath(PathId id, const Scene& scene);
    void touchRules(const Scene& scene);
    void touchTags(const Scene& scene);
    void touchNumbers(const Scene& scene);
    void touchCues(const Scene& scene);
    void touchSurface(const Scene& scene);
    void touchSteps(const Scene& scene);

    [[nodiscard]] IndividualId nextIdBefore() const { return m_nextIdBefore; }
    /// From the scene before the edit to `scene`.
    [[nodiscard]] SceneDelta delta(const Scene& scene) const;

private:
    IndividualId m_nextIdBefore;
    std::vector<IndividualId> m_added; ///< ascending, all present
    IndividualRows m_removed = IndividualRows::withDefaults({});
    std::map<ColumnId, FirstTouch> m_touched;
    std::map<TemplateId, std::optional<TemplateEntry>> m_templates;
    std::map<std::uint8_t, std::optional<StageEntry>> m_stages;
    std::optional<std::vector<NamedCamera>> m_cameras;
    std::optional<Lighting> m_lighting;
    std::map<PlaceId, std::optional<Place>> m_places;
    std::map<PathId, std::optional<Path>> m_paths;
    std::optional<std::vector<Rule>> m_rules;
    std::optional<std::vector<TagName>> m_tags;
    std::optional<std::vector<NumberName>> m_numbers;
    std::optional<std::vector<Cue>> m_cues;
    std::optional<SurfaceSettings> m_surface;
    std::optional<std::uint32_t> m_steps;
};

} // namespace crowd::model
