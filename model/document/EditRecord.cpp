// SPDX-License-Identifier: MIT
#include "model/document/EditRecord.h"

#include <algorithm>
#include <iterator>

#include "model/document/EntryCompare.h"

namespace crowd::model {

namespace {

using Ids = std::vector<IndividualId>;

Ids minus(std::span<const IndividualId> a, std::span<const IndividualId> b)
{
    Ids difference;
    std::ranges::set_difference(a, b, std::back_inserter(difference));
    return difference;
}

IndividualRows mergedRows(const IndividualRows& a, const IndividualRows& b)
{
    Population both;
    both.add(a);
    both.add(b);
    return both.rows(both.ids());
}

/// Entries by ascending id.
template<class Entry>
std::optional<Entry> entryOf(const std::vector<Entry>& entries, decltype(Entry::id) id)
{
    const auto found = std::ranges::lower_bound(entries, id, {}, &Entry::id);
    const bool isThere = found != entries.end() && found->id == id;
    return isThere ? std::optional<Entry>(*found) : std::nullopt;
}

/// First-touch values of the entries against today's, by id.
template<class Entry>
std::vector<EntryDelta<Entry>>
entryDeltas(const std::map<decltype(Entry::id), std::optional<Entry>>& before,
            const std::vector<Entry>& entries)
{
    std::vector<EntryDelta<Entry>> deltas;
    for (const auto& [id, entry] : before) {
        EntryDelta<Entry> delta{entry, entryOf(entries, id)};
        const bool wasThere = delta.before.has_value();
        const bool isThere = delta.after.has_value();
        if (wasThere != isThere || (wasThere && !isSame(*delta.before, *delta.after))) {
            deltas.push_back(std::move(delta));
        }
    }
    return deltas;
}

} // namespace

void EditRecord::addIndividuals(std::span<const IndividualId> ids)
{
    m_added.insert(m_added.end(), ids.begin(), ids.end());
}

void EditRecord::removeIndividuals(std::span<const IndividualId> ids, const Population& population)
{
    const Ids old = minus(ids, m_added);
    m_added = minus(m_added, ids);
    IndividualRows originals = population.rows(old);
    for (auto& [column, touched] : m_touched) {
        touched.moveInto(old, originals.bytes[static_cast<std::size_t>(column)],
                         columnInfo(column).stride);
    }
    m_removed = mergedRows(m_removed, originals);
}

void EditRecord::touchColumn(ColumnId column, std::span<const IndividualId> ids,
                             const Population& population)
{
    const Ids old = minus(ids, m_added);
    m_touched[column].remember(old, population.values(column, old), columnInfo(column).stride);
}

void EditRecord::touchTemplate(TemplateId id, const Scene& scene)
{
    m_templates.try_emplace(id, entryOf(scene.templates, id));
}

void EditRecord::touchStage(std::uint8_t id, const Scene& scene)
{
    m_stages.try_emplace(id, entryOf(scene.stages, id));
}

void EditRecord::touchCameras(const Scene& scene)
{
    if (!m_cameras) {
        m_cameras = scene.cameras;
    }
}

void EditRecord::touchLighting(const Scene& scene)
{
    if (!m_lighting) {
        m_lighting = scene.lighting;
    }
}

void EditRecord::touchPlace(PlaceId id, const Scene& scene)
{
    m_places.try_emplace(id, entryOf(scene.places, id));
}

void EditRecord::touchPath(PathId id, const Scene& scene)
{
    m_paths.try_emplace(id, entryOf(scene.paths, id));
}

void EditRecord::touchRules(const Scene& scene)
{
    if (!m_rules) {
        m_rules = scene.rules;
    }
}

void EditRecord::touchTags(const Scene& scene)
{
    if (!m_tags) {
        m_tags = scene.tags;
    }
}

void EditRecord::touchNumbers(const Scene& scene)
{
    if (!m_numbers) {
        m_numbers = scene.numbers;
    }
}

void EditRecord::touchCues(const Scene& scene)
{
    if (!m_cues) {
        m_cues = scene.cues;
    }
}

void EditRecord::touchSurface(const Scene& scene)
{
    if (!m_surface) {
        m_surface = scene.surface;
    }
}

void EditRecord::touchSteps(const Scene& scene)
{
    if (!m_steps) {
        m_steps = scene.stepsPerSecond;
    }
}

SceneDelta EditRecord::delta(const Scene& scene) const
{
    SceneDelta delta;
    delta.added = StoredRows(scene.population.rows(m_added));
    delta.removed = StoredRows(m_removed);
    for (const auto& [column, touched] : m_touched) {
        ColumnDelta change = touched.changes(column, scene.population);
        if (!change.ids.empty()) {
            delta.columns.push_back(std::move(change));
        }
    }
    delta.nextIdBefore = m_nextIdBefore;
    delta.nextIdAfter = scene.nextId;
    delta.templates = entryDeltas(m_templates, scene.templates);
    delta.stages = entryDeltas(m_stages, scene.stages);
    if (m_cameras && !isSame(*m_cameras, scene.cameras)) {
        delta.cameras = ValueDelta<std::vector<NamedCamera>>{*m_cameras, scene.cameras};
    }
    if (m_lighting && !isSame(*m_lighting, scene.lighting)) {
        delta.lighting = ValueDelta<Lighting>{*m_lighting, scene.lighting};
    }
    delta.places = entryDeltas(m_places, scene.places);
    delta.paths = entryDeltas(m_paths, scene.paths);
    if (m_rules && !isSame(*m_rules, scene.rules)) {
        delta.rules = ValueDelta<std::vector<Rule>>{*m_rules, scene.rules};
    }
    if (m_tags && *m_tags != scene.tags) {
        delta.tags = ValueDelta<std::vector<TagName>>{*m_tags, scene.tags};
    }
    if (m_numbers && !isSame(*m_numbers, scene.numbers)) {
        delta.numbers = ValueDelta<std::vector<NumberName>>{*m_numbers, scene.numbers};
    }
    if (m_cues && !isSame(*m_cues, scene.cues)) {
        delta.cues = ValueDelta<std::vector<Cue>>{*m_cues, scene.cues};
    }
    if (m_surface && *m_surface != scene.surface) {
        delta.surface = ValueDelta<SurfaceSettings>{*m_surface, scene.surface};
    }
    if (m_steps && *m_steps != scene.stepsPerSecond) {
        delta.stepsPerSecond = ValueDelta<std::uint32_t>{*m_steps, scene.stepsPerSecond};
    }
    return delta;
}

} // namespace crowd::model
