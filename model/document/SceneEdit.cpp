// SPDX-License-Identifier: MIT
#include "model/document/SceneEdit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>

#include "model/document/SceneCommand.h"
#include "model/document/SceneDelta.h"

namespace crowd::model {

namespace {

using Ids = std::vector<IndividualId>;

Ids minus(std::span<const IndividualId> a, std::span<const IndividualId> b)
{
    Ids difference;
    std::ranges::set_difference(a, b, std::back_inserter(difference));
    return difference;
}

Ids united(std::span<const IndividualId> a, std::span<const IndividualId> b)
{
    Ids all;
    std::ranges::set_union(a, b, std::back_inserter(all));
    return all;
}

/// Values of one column before the edit, kept at first touch.
class FirstTouch
{
public:
    /// `values` in the order of `ids`; ids already known are left alone.
    void remember(std::span<const IndividualId> ids, std::span<const std::byte> values,
                  std::size_t stride)
    {
        const Ids merged = united(m_ids, ids);
        std::vector<std::byte> bytes(merged.size() * stride);
        std::size_t known = 0;
        std::size_t fresh = 0;
        for (std::size_t i = 0; i < merged.size(); ++i) {
            const bool isKnown = known < m_ids.size() && m_ids[known] == merged[i];
            const std::byte* from = isKnown ? &m_bytes[known * stride] : &values[fresh * stride];
            std::memcpy(&bytes[i * stride], from, stride);
            known += isKnown ? 1 : 0;
            fresh += fresh < ids.size() && ids[fresh] == merged[i] ? 1 : 0;
        }
        m_ids = merged;
        m_bytes = std::move(bytes);
    }

    /// Takes the values of those of `ids` that are known out of here and into `rows`.
    void moveInto(std::span<const IndividualId> ids, std::span<std::byte> rows, std::size_t stride)
    {
        Ids keptIds;
        std::vector<std::byte> keptBytes;
        std::size_t row = 0;
        for (std::size_t i = 0; i < m_ids.size(); ++i) {
            const auto from = m_bytes.begin() + static_cast<std::ptrdiff_t>(i * stride);
            while (row < ids.size() && ids[row] < m_ids[i]) {
                ++row;
            }
            if (row < ids.size() && ids[row] == m_ids[i]) {
                std::copy_n(from, stride, rows.begin() + static_cast<std::ptrdiff_t>(row * stride));
            } else {
                keptIds.push_back(m_ids[i]);
                keptBytes.insert(keptBytes.end(), from, from + static_cast<std::ptrdiff_t>(stride));
            }
        }
        m_ids = std::move(keptIds);
        m_bytes = std::move(keptBytes);
    }

    [[nodiscard]] const Ids& ids() const { return m_ids; }
    [[nodiscard]] const std::vector<std::byte>& bytes() const { return m_bytes; }

private:
    Ids m_ids;
    std::vector<std::byte> m_bytes;
};

IndividualRows mergedRows(const IndividualRows& a, const IndividualRows& b)
{
    Population both;
    both.add(a);
    both.add(b);
    return both.rows(both.ids());
}

void keepOnceIfUniform(std::vector<std::byte>& bytes, std::size_t stride)
{
    for (std::size_t i = stride; i < bytes.size(); i += stride) {
        if (std::memcmp(bytes.data(), &bytes[i], stride) != 0) {
            return;
        }
    }
    bytes.resize(std::min(bytes.size(), stride));
    bytes.shrink_to_fit();
}

/// What differs between the remembered values and today's.
ColumnDelta changedValues(ColumnId column, const FirstTouch& touched, const Population& population)
{
    const std::size_t stride = columnInfo(column).stride;
    const std::vector<std::byte> now = population.values(column, touched.ids());
    ColumnDelta delta;
    delta.column = column;
    for (std::size_t i = 0; i < touched.ids().size(); ++i) {
        const std::byte* before = &touched.bytes()[i * stride];
        const std::byte* after = &now[i * stride];
        if (std::memcmp(before, after, stride) != 0) {
            delta.ids.push_back(touched.ids()[i]);
            delta.before.insert(delta.before.end(), before, before + stride);
            delta.after.insert(delta.after.end(), after, after + stride);
        }
    }
    keepOnceIfUniform(delta.before, stride);
    keepOnceIfUniform(delta.after, stride);
    return delta;
}

template<class Entry>
std::optional<Entry> entryOf(const std::vector<Entry>& entries, decltype(Entry::id) id)
{
    const auto found = std::ranges::find(entries, id, &Entry::id);
    return found == entries.end() ? std::nullopt : std::optional<Entry>(*found);
}

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

template<class Entry>
decltype(Entry::id) freeId(const std::vector<Entry>& entries)
{
    using Id = decltype(Entry::id);
    return static_cast<Id>(entries.empty() ? 1 : entries.back().id + 1);
}

bool isSameSpeed(float a, float b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}

bool isSame(const TemplateEntry& a, const TemplateEntry& b)
{
    return a.name == b.name && a.path == b.path && a.import == b.import &&
           a.clipNames == b.clipNames && a.asset == b.asset && a.problem == b.problem &&
           std::ranges::equal(a.clipSpeeds, b.clipSpeeds, isSameSpeed);
}

bool isSame(const StageEntry& a, const StageEntry& b)
{
    return a.name == b.name && a.path == b.path && a.position == b.position &&
           a.headingRadians == b.headingRadians && a.scale == b.scale && a.asset == b.asset &&
           a.problem == b.problem;
}

bool isSame(const NamedCamera& a, const NamedCamera& b)
{
    return a.name == b.name && a.camera == b.camera;
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

struct SceneEdit::Private
{
    IndividualId nextIdBefore = 1;
    Ids added; ///< ascending, all present
    IndividualRows removed = IndividualRows::withDefaults({});
    std::array<FirstTouch, kColumnCount> touched;
    std::map<TemplateId, std::optional<TemplateEntry>> templates;
    std::map<std::uint8_t, std::optional<StageEntry>> stages;
    std::optional<std::vector<NamedCamera>> cameras;
    std::optional<Lighting> lighting;

    [[nodiscard]] SceneDelta delta(const Scene& scene) const;
};

SceneDelta SceneEdit::Private::delta(const Scene& scene) const
{
    SceneDelta delta;
    delta.added = scene.population.rows(added);
    delta.removed = removed;
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        if (!touched[c].ids().empty()) {
            ColumnDelta change =
                changedValues(static_cast<ColumnId>(c), touched[c], scene.population);
            if (!change.ids.empty()) {
                delta.columns.push_back(std::move(change));
            }
        }
    }
    delta.nextIdBefore = nextIdBefore;
    delta.nextIdAfter = scene.nextId;
    delta.templates = entryDeltas(templates, scene.templates);
    delta.stages = entryDeltas(stages, scene.stages);
    if (cameras && !std::ranges::equal(*cameras, scene.cameras,
                                       [](const auto& a, const auto& b) { return isSame(a, b); })) {
        delta.cameras = ValueDelta<std::vector<NamedCamera>>{*cameras, scene.cameras};
    }
    if (lighting && !(*lighting == scene.lighting)) {
        delta.lighting = ValueDelta<Lighting>{*lighting, scene.lighting};
    }
    return delta;
}

SceneEdit::SceneEdit(SceneDocument& document)
    : m_document(document), m_private(std::make_unique<Private>())
{
    m_document.m_openEdit = this;
    m_private->nextIdBefore = scene().nextId;
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
    std::iota(rows.ids.begin(), rows.ids.end(), target.nextId);
    target.nextId += static_cast<IndividualId>(rows.ids.size());
    target.population.add(rows);
    m_private->added.insert(m_private->added.end(), rows.ids.begin(), rows.ids.end());
    m_document.announce(IndividualsAdded{rows.ids});
    return rows.ids;
}

void SceneEdit::removeIndividuals(std::span<const IndividualId> ids)
{
    if (ids.empty()) {
        return;
    }
    const Ids old = minus(ids, m_private->added);
    m_private->added = minus(m_private->added, ids);
    IndividualRows originals = scene().population.rows(old);
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        m_private->touched[c].moveInto(old, originals.bytes[c],
                                       columnInfo(static_cast<ColumnId>(c)).stride);
    }
    m_private->removed = mergedRows(m_private->removed, originals);
    (void)m_document.m_scene.population.remove(ids);
    m_document.announce(IndividualsRemoved{Ids(ids.begin(), ids.end())});
}

void SceneEdit::setColumn(ColumnId column, std::span<const IndividualId> ids,
                          std::span<const std::byte> bytes)
{
    if (ids.empty()) {
        return;
    }
    Population& population = m_document.m_scene.population;
    const Ids old = minus(ids, m_private->added);
    m_private->touched[static_cast<std::size_t>(column)].remember(
        old, population.values(column, old), columnInfo(column).stride);
    population.setValues(column, ids, bytes);
    m_document.announce(
        ColumnsChanged{Ids(ids.begin(), ids.end()), 1U << static_cast<unsigned>(column)});
}

TemplateId SceneEdit::addTemplate(TemplateEntry entry)
{
    if (entry.id == 0) {
        entry.id = freeId(scene().templates);
    }
    changeTemplate(entry);
    return entry.id;
}

void SceneEdit::removeTemplate(TemplateId id)
{
    auto& templates = m_document.m_scene.templates;
    m_private->templates.try_emplace(id, entryOf(templates, id));
    std::erase_if(templates, [id](const TemplateEntry& entry) { return entry.id == id; });
    m_document.announce(TemplatesChanged{});
}

void SceneEdit::changeTemplate(const TemplateEntry& entry)
{
    auto& templates = m_document.m_scene.templates;
    m_private->templates.try_emplace(entry.id, entryOf(templates, entry.id));
    putEntry(templates, entry);
    m_document.announce(TemplatesChanged{});
}

std::uint8_t SceneEdit::addStage(StageEntry entry)
{
    if (entry.id == 0) {
        entry.id = freeId(scene().stages);
    }
    changeStage(entry);
    return entry.id;
}

void SceneEdit::removeStage(std::uint8_t id)
{
    auto& stages = m_document.m_scene.stages;
    m_private->stages.try_emplace(id, entryOf(stages, id));
    std::erase_if(stages, [id](const StageEntry& entry) { return entry.id == id; });
    m_document.announce(StagesChanged{});
}

void SceneEdit::changeStage(const StageEntry& entry)
{
    auto& stages = m_document.m_scene.stages;
    m_private->stages.try_emplace(entry.id, entryOf(stages, entry.id));
    putEntry(stages, entry);
    m_document.announce(StagesChanged{});
}

void SceneEdit::setCameras(std::vector<NamedCamera> cameras)
{
    if (!m_private->cameras) {
        m_private->cameras = scene().cameras;
    }
    m_document.m_scene.cameras = std::move(cameras);
    m_document.announce(CamerasChanged{});
}

void SceneEdit::setLighting(const Lighting& lighting)
{
    if (!m_private->lighting) {
        m_private->lighting = scene().lighting;
    }
    m_document.m_scene.lighting = lighting;
    m_document.announce(LightingChanged{});
}

void SceneEdit::rollback()
{
    const SceneDelta delta = m_private->delta(scene());
    applyDelta(m_document.m_scene, delta, DeltaDirection::Undo,
               [this](const SceneChange& change) { m_document.announce(change); });
    const IndividualId nextId = m_private->nextIdBefore;
    *m_private = Private{};
    m_private->nextIdBefore = nextId;
}

bool SceneEdit::commit(const QString& undoText)
{
    SceneDelta delta = m_private->delta(scene());
    m_document.m_openEdit = nullptr;
    if (delta.isEmpty()) {
        m_document.m_scene.nextId = m_private->nextIdBefore;
        return false;
    }
    m_document.m_undoStack.push(new SceneCommand(m_document, std::move(delta), undoText));
    return true;
}

} // namespace crowd::model
