// SPDX-License-Identifier: MIT
#include "model/document/SceneEdit.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "model/document/EditRecord.h"
#include "model/document/MemberEntries.h"
#include "model/relations/RelatedPeople.h"

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

/// The highest path that people or rules name, there or not: a new one must not be taken for it.
PathId highestPathNamed(const Scene& scene)
{
    PathId highest = 0;
    for (const PathId path : scene.population.column(columns::path)) {
        highest = std::max(highest, path);
    }
    for (const Rule& rule : scene.rules) {
        for (const PathId path : idsNamedIn(rule, FieldRole::Path)) {
            highest = std::max(highest, path);
        }
    }
    return highest;
}

PlaceId highestPlaceNamed(const Scene& scene)
{
    PlaceId highest = 0;
    for (const Rule& rule : scene.rules) {
        for (const PlaceId place : idsNamedIn(rule, FieldRole::Place)) {
            highest = std::max(highest, place);
        }
    }
    return highest;
}

/// As freeId(), above `named` where there is room.
template<class Entry>
std::uint32_t freeIdAbove(const std::vector<Entry>& entries, std::uint32_t named)
{
    const std::uint32_t free = freeId(entries);
    const bool hasRoom = named < std::numeric_limits<std::uint32_t>::max();
    return free <= named && hasRoom && free != 0 ? named + 1 : free;
}

/// Calls act(id) for entries that are in one of the two only, or differ; both by ascending id.
template<class Entry, class Act>
void forEachDifferent(const std::vector<Entry>& now, const std::vector<Entry>& wanted,
                      const Act& act)
{
    auto old = now.begin();
    auto coming = wanted.begin();
    while (old != now.end() || coming != wanted.end()) {
        const bool isOldOnly = coming == wanted.end() || (old != now.end() && old->id < coming->id);
        const bool isComingOnly = !isOldOnly && (old == now.end() || coming->id < old->id);
        if (isOldOnly || isComingOnly || !isSame(*old, *coming)) {
            act(isOldOnly ? old->id : coming->id);
        }
        old += isComingOnly ? 0 : 1;
        coming += isOldOnly ? 0 : 1;
    }
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

const EarlierPeople& SceneEdit::earlierPeople() const
{
    return m_document.m_earlier;
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
    forgetRelations(ids);
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
    m_document.announce(ColumnsChanged{{ids.begin(), ids.end()}, {column}});
}

void SceneEdit::announce(const ChangeOver& change)
{
    Q_EMIT m_document.changingOver(change);
}

template<class M>
requires(M::kind == MemberKind::Value) void SceneEdit::set(typename M::Type value)
{
    m_record->touch<M>(scene());
    M::of(m_document.m_scene) = std::move(value);
    m_document.announce(typename M::Changed());
}

void SceneEdit::setRelationKinds(std::vector<RelationKind> kinds)
{
    std::vector<Relation> leaving;
    std::vector<Relation> coming;
    for (const Relation& each : scene().relations.all()) {
        const RelationKind* kind = findRelation(kinds, each.kind);
        const Relation wanted = kind != nullptr ? canonical(*kind, each) : Relation();
        if (wanted != each) {
            leaving.push_back(each);
        }
        if (wanted != each && kind != nullptr) {
            coming.push_back(wanted);
        }
    }
    set<members::RelationKinds>(std::move(kinds));
    changeRelations(leaving, true);
    changeRelations(coming, false);
}

void SceneEdit::relate(std::span<const Relation> relations)
{
    std::vector<Relation> coming;
    coming.reserve(relations.size());
    const RelationKind* kind = nullptr;
    for (const Relation& each : relations) {
        if (kind == nullptr || kind->id != each.kind) {
            kind = findRelation(scene().relationKinds, each.kind);
        }
        assert(kind != nullptr);
        coming.push_back(canonical(*kind, each));
    }
    changeRelations(coming, false);
}

void SceneEdit::unrelate(std::span<const Relation> relations)
{
    std::vector<Relation> leaving;
    leaving.reserve(relations.size());
    for (const Relation& each : relations) {
        const RelationKind* kind = findRelation(scene().relationKinds, each.kind);
        leaving.push_back(kind != nullptr ? canonical(*kind, each) : each);
    }
    changeRelations(leaving, true);
}

void SceneEdit::forgetRelations(std::span<const IndividualId> ids)
{
    changeRelations(relationsOf(scene(), ids, 0), true);
}

void SceneEdit::changeRelations(std::span<const Relation> relations, bool isGone)
{
    if (relations.empty()) {
        return;
    }
    m_record->touch<members::Relations>(scene());
    RelationTable& table = m_document.m_scene.relations;
    isGone ? table.remove(relations) : table.put(relations);
    m_document.announce(RelationsChanged{});
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
    m_record->touch<members::Templates>(id, scene());
    std::erase_if(templates, [id](const TemplateEntry& entry) { return entry.id == id; });
    m_document.announce(TemplatesChanged{});
}

void SceneEdit::changeTemplate(const TemplateEntry& entry)
{
    auto& templates = m_document.m_scene.templates;
    m_record->touch<members::Templates>(entry.id, scene());
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
    m_record->touch<members::Stages>(id, scene());
    std::erase_if(stages, [id](const StageEntry& entry) { return entry.id == id; });
    m_document.announce(StagesChanged{});
}

void SceneEdit::changeStage(const StageEntry& entry)
{
    auto& stages = m_document.m_scene.stages;
    m_record->touch<members::Stages>(entry.id, scene());
    putEntry(stages, entry);
    m_document.announce(StagesChanged{});
}

PlaceId SceneEdit::addPlace(Place place)
{
    if (place.id == 0) {
        place.id = freeIdAbove(scene().places, highestPlaceNamed(scene()));
    }
    if (place.id != 0) {
        changePlace(place);
    }
    return place.id;
}

void SceneEdit::changePlace(const Place& place)
{
    m_record->touch<members::Places>(place.id, scene());
    putEntry(m_document.m_scene.places, place);
    m_document.announce(PathsChanged{});
}

void SceneEdit::removePlace(PlaceId id)
{
    for (Path& path : m_document.m_scene.paths) {
        const bool isThere = std::ranges::find(path.places, id) != path.places.end();
        if (isThere ||
            std::ranges::find(path.branches, id, &PathBranch::place) != path.branches.end()) {
            m_record->touch<members::Paths>(path.id, scene());
            std::erase(path.places, id);
            std::erase_if(path.branches, [id](const PathBranch& b) { return b.place == id; });
        }
    }
    m_record->touch<members::Places>(id, scene());
    std::erase_if(m_document.m_scene.places, [id](const Place& place) { return place.id == id; });
    m_document.announce(PathsChanged{});
}

PathId SceneEdit::addPath(Path path)
{
    if (path.id == 0) {
        path.id = freeIdAbove(scene().paths, highestPathNamed(scene()));
    }
    if (path.id != 0) {
        changePath(path);
    }
    return path.id;
}

void SceneEdit::changePath(const Path& path)
{
    m_record->touch<members::Paths>(path.id, scene());
    putEntry(m_document.m_scene.paths, path);
    m_document.announce(PathsChanged{});
}

void SceneEdit::removePath(PathId id)
{
    const PathId none = 0;
    setColumn(columns::path, peopleWith(scene().population, columns::path, id),
              std::span<const PathId>(&none, 1));
    for (Path& path : m_document.m_scene.paths) {
        if (std::ranges::find(path.branches, id, &PathBranch::path) != path.branches.end()) {
            m_record->touch<members::Paths>(path.id, scene());
            std::erase_if(path.branches, [id](const PathBranch& b) { return b.path == id; });
        }
    }
    m_record->touch<members::Paths>(id, scene());
    std::erase_if(m_document.m_scene.paths, [id](const Path& path) { return path.id == id; });
    m_document.announce(PathsChanged{});
}

void SceneEdit::setPlacesAndPaths(std::vector<Place> places, std::vector<Path> paths)
{
    const auto isGone = [&paths](PathId path) {
        return path != 0 && !std::ranges::binary_search(paths, path, {}, &Path::id);
    };
    std::vector<IndividualId> walkers;
    const auto followed = scene().population.column(columns::path);
    for (std::size_t row = 0; row < followed.size(); ++row) {
        if (isGone(followed[row])) {
            walkers.push_back(scene().population.ids()[row]);
        }
    }
    const PathId none = 0;
    setColumn(columns::path, walkers, std::span<const PathId>(&none, 1));
    Scene& target = m_document.m_scene;
    forEachDifferent(target.places, places,
                     [this](PlaceId id) { m_record->touch<members::Places>(id, scene()); });
    forEachDifferent(target.paths, paths,
                     [this](PathId id) { m_record->touch<members::Paths>(id, scene()); });
    target.places = std::move(places);
    target.paths = std::move(paths);
    m_document.announce(PathsChanged{});
}

void SceneEdit::rollback()
{
    const SceneDelta delta = m_record->delta(scene());
    applyDelta(m_document.m_scene, delta, DeltaDirection::Undo,
               [this](const SceneChange& change) { m_document.announce(change); });
    *m_record = EditRecord(m_record->nextIdBefore());
}

bool SceneEdit::commit(const QString& undoText, const RecordedStroke* stroke)
{
    SceneDelta delta = m_record->delta(scene());
    m_document.m_openEdit = nullptr;
    if (delta.isEmpty()) {
        m_document.m_scene.nextId = m_record->nextIdBefore();
        return false;
    }
    m_document.push(std::move(delta), undoText, stroke);
    return true;
}

namespace {

template<class M>
constexpr auto setterOf()
{
    if constexpr (M::kind == MemberKind::Value) {
        return std::tuple(&SceneEdit::set<M>);
    } else {
        return std::tuple();
    }
}

template<class... M>
constexpr auto settersOf(const std::tuple<M...>*)
{
    return std::tuple_cat(setterOf<M>()...);
}

/// set() of every member is compiled here, and linked by those who edit.
[[gnu::used]] constexpr auto kSetters = settersOf(static_cast<const SceneMembers*>(nullptr));

} // namespace

} // namespace crowd::model
