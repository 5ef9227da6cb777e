// SPDX-License-Identifier: MIT
#include "model/document/SceneEdit.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

#include "model/document/EditRecord.h"

namespace crowd::model {

namespace {

template<class Entry>
void putEntry(std::vector<Entry>& entries, const Entry& entry)
{
    const auto place = std::ranges::lower_bound(entries, entry.id, {}, &Entry::id);
    if (place != entries.end() && place->id == entry.id) {
        *place = entry;
    } else {
        entries.insert(place, entry);
    }
}

/// One above the highest; the lowest gap when that is the highest there can be; 0 when all are
/// taken.
template<class Entry>
decltype(Entry::id) freeId(const std::vector<Entry>& entries)
{
    using Id = decltype(Entry::id);
    if (entries.empty() || entries.back().id < std::numeric_limits<Id>::max()) {
        return static_cast<Id>(entries.empty() ? 1 : entries.back().id + 1);
    }
    Id id = 1;
    for (const Entry& entry : entries) {
        if (entry.id != id) {
            return id;
        }
        ++id;
    }
    return 0;
}

} // namespace

SceneEdit::SceneEdit(SceneDocument& document)
    : m_document(document), m_record(std::make_unique<EditRecord>(document.scene().nextId))
{
    m_document.m_openEdit = this;
}

SceneEdit::~SceneEdit()
{
    if (m_document.m_openEdit == this) {
        rollback();
        m_document.m_openEdit = nullptr;
    }
}

const Scene& SceneEdit::scene() const
{
    return m_document.m_scene;
}

std::vector<IndividualId> SceneEdit::addIndividuals(IndividualRows rows)
{
    Scene& target = m_document.m_scene;
    assert(rows.ids.size() < std::numeric_limits<IndividualId>::max() - target.nextId);
    std::iota(rows.ids.begin(), rows.ids.end(), target.nextId);
    m_record->addIndividuals(rows.ids);
    target.nextId += static_cast<IndividualId>(rows.ids.size());
    target.population.add(rows);
    m_document.announce(IndividualsAdded{rows.ids});
    return rows.ids;
}

void SceneEdit::removeIndividuals(std::span<const IndividualId> ids)
{
    if (ids.empty()) {
        return;
    }
    m_record->removeIndividuals(ids, scene().population);
    (void)m_document.m_scene.population.remove(ids);
    m_document.announce(IndividualsRemoved{{ids.begin(), ids.end()}});
}

void SceneEdit::setColumn(ColumnId column, std::span<const IndividualId> ids,
                          std::span<const std::byte> bytes)
{
    if (ids.empty()) {
        return;
    }
    Population& population = m_document.m_scene.population;
    m_record->touchColumn(column, ids, population);
    population.setValues(column, ids, bytes);
    m_document.announce(
        ColumnsChanged{{ids.begin(), ids.end()}, 1U << static_cast<unsigned>(column)});
}

TemplateId SceneEdit::addTemplate(TemplateEntry entry)
{
    if (entry.id == 0) {
        entry.id = freeId(scene().templates);
    }
    if (entry.id == 0) {
        return 0;
    }
    changeTemplate(entry);
    return entry.id;
}

void SceneEdit::removeTemplate(TemplateId id)
{
    auto& templates = m_document.m_scene.templates;
    m_record->touchTemplate(id, scene());
    std::erase_if(templates, [id](const TemplateEntry& entry) { return entry.id == id; });
    m_document.announce(TemplatesChanged{});
}

void SceneEdit::changeTemplate(const TemplateEntry& entry)
{
    auto& templates = m_document.m_scene.templates;
    m_record->touchTemplate(entry.id, scene());
    putEntry(templates, entry);
    m_document.announce(TemplatesChanged{});
}

std::uint8_t SceneEdit::addStage(StageEntry entry)
{
    if (entry.id == 0) {
        entry.id = freeId(scene().stages);
    }
    if (entry.id == 0) {
        return 0;
    }
    changeStage(entry);
    return entry.id;
}

void SceneEdit::removeStage(std::uint8_t id)
{
    auto& stages = m_document.m_scene.stages;
    m_record->touchStage(id, scene());
    std::erase_if(stages, [id](const StageEntry& entry) { return entry.id == id; });
    m_document.announce(StagesChanged{});
}

void SceneEdit::changeStage(const StageEntry& entry)
{
    auto& stages = m_document.m_scene.stages;
    m_record->touchStage(entry.id, scene());
    putEntry(stages, entry);
    m_document.announce(StagesChanged{});
}

void SceneEdit::setCameras(std::vector<NamedCamera> cameras)
{
    m_record->touchCameras(scene());
    m_document.m_scene.cameras = std::move(cameras);
    m_document.announce(CamerasChanged{});
}

void SceneEdit::setLighting(const Lighting& lighting)
{
    m_record->touchLighting(scene());
    m_document.m_scene.lighting = lighting;
    m_document.announce(LightingChanged{});
}

void SceneEdit::rollback()
{
    const SceneDelta delta = m_record->delta(scene());
    applyDelta(m_document.m_scene, delta, DeltaDirection::Undo,
               [this](const SceneChange& change) { m_document.announce(change); });
    *m_record = EditRecord(m_record->nextIdBefore());
}

bool SceneEdit::commit(const QString& undoText)
{
    SceneDelta delta = m_record->delta(scene());
    m_document.m_openEdit = nullptr;
    if (delta.isEmpty()) {
        m_document.m_scene.nextId = m_record->nextIdBefore();
        return false;
    }
    m_document.push(std::move(delta), undoText);
    return true;
}

} // namespace crowd::model
