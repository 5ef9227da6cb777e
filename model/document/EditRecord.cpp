// SPDX-License-Identifier: MIT
#include "model/document/EditRecord.h"

#include <algorithm>
#include <iterator>

#include "model/document/MemberEntries.h"

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

template<class Value>
std::optional<ValueDelta<Value>> valueDelta(const std::optional<Value>& before, const Value& now)
{
    const bool isChanged = before && !isSame(*before, now);
    return isChanged ? std::optional(ValueDelta<Value>{*before, now}) : std::nullopt;
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
    FirstTouch& touched = m_touched[column];
    const std::size_t stride = columnInfo(column).stride;
    if (m_added.empty()) {
        touched.remember(ids, population.values(column, ids), stride);
        return;
    }
    const Ids old = minus(ids, m_added);
    touched.remember(old, population.values(column, old), stride);
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
    forEachMember([&]<class M>(const M&) {
        const auto& before = std::get<FirstMember<M>>(m_members).before;
        if constexpr (M::kind == MemberKind::Entries) {
            delta.of<M>() = entryDeltas(before, M::of(scene));
        } else if constexpr (M::kind == MemberKind::Table) {
            delta.of<M>() = before ? M::of(scene).since(*before) : typename M::Type::Delta();
        } else {
            delta.of<M>() = valueDelta(before, M::of(scene));
        }
    });
    return delta;
}

} // namespace crowd::model
