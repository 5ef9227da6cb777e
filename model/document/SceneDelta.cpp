// SPDX-License-Identifier: MIT
#include "model/document/SceneDelta.h"

#include <algorithm>
#include <iterator>

#include "model/document/MemberEntries.h"

namespace crowd::model {

namespace {

using Announce = std::function<void(const SceneChange&)>;

template<class Entry>
std::size_t deltaBytes(const std::vector<EntryDelta<Entry>>& deltas)
{
    std::size_t total = 0;
    for (const EntryDelta<Entry>& delta : deltas) {
        total += delta.before ? bytesOf(*delta.before) : sizeof(Entry);
        total += delta.after ? bytesOf(*delta.after) : sizeof(Entry);
    }
    return total;
}

template<class Value>
std::size_t deltaBytes(const std::optional<ValueDelta<Value>>& delta)
{
    return delta ? bytesOf(delta->before) + bytesOf(delta->after) : 0;
}

std::size_t deltaBytes(const RelationDelta&)
{
    return 0; // see bulkBytes()
}

template<class Entry>
bool hasChanged(const std::vector<EntryDelta<Entry>>& deltas)
{
    return !deltas.empty();
}
template<class Value>
bool hasChanged(const std::optional<ValueDelta<Value>>& delta)
{
    return delta.has_value();
}
bool hasChanged(const RelationDelta& delta)
{
    return !delta.isEmpty();
}

void swapIndividuals(Scene& scene, const StoredRows& leaving, const StoredRows& coming,
                     const Announce& announce)
{
    if (!leaving.ids.empty()) {
        (void)scene.population.remove(leaving.ids);
        announce(IndividualsRemoved{leaving.ids});
    }
    if (!coming.ids.empty()) {
        scene.population.add(coming.unpacked());
        announce(IndividualsAdded{coming.ids});
    }
}

/// An asset that was loaded meanwhile belongs to the file, not to the edit: it is kept.
void keepLoadedAsset(const TemplateEntry& current, TemplateEntry& coming)
{
    if (!coming.asset && current.path == coming.path && current.import == coming.import) {
        coming.asset = current.asset;
        coming.problem = current.problem;
    }
}

void keepLoadedAsset(const StageEntry& current, StageEntry& coming)
{
    if (!coming.asset && current.path == coming.path) {
        coming.asset = current.asset;
        coming.problem = current.problem;
    }
}

/// Places and paths have no asset.
template<class Entry>
void keepLoadedAsset(const Entry& /*current*/, Entry& /*coming*/)
{
}

/// Both by ascending id. In one go: a script may bring hundreds of thousands of places.
template<class Entry>
void swapEntries(std::vector<Entry>& entries, const std::vector<EntryDelta<Entry>>& deltas,
                 DeltaDirection direction)
{
    const bool isRedo = direction == DeltaDirection::Redo;
    std::vector<Entry> swapped;
    swapped.reserve(entries.size() + deltas.size());
    auto current = entries.begin();
    for (const EntryDelta<Entry>& delta : deltas) {
        const std::optional<Entry>& from = isRedo ? delta.before : delta.after;
        const std::optional<Entry>& to = isRedo ? delta.after : delta.before;
        const auto id = from ? from->id : to->id;
        const auto next = std::ranges::lower_bound(current, entries.end(), id, {}, &Entry::id);
        std::move(current, next, std::back_inserter(swapped));
        current = next;
        if (to) {
            swapped.push_back(*to);
        }
        if (from) {
            if (to) {
                keepLoadedAsset(*current, swapped.back());
            }
            ++current;
        }
    }
    std::move(current, entries.end(), std::back_inserter(swapped));
    entries = std::move(swapped);
}

template<class Value>
void swapValue(Value& value, const std::optional<ValueDelta<Value>>& delta,
               DeltaDirection direction)
{
    if (delta) {
        value = direction == DeltaDirection::Redo ? delta->after : delta->before;
    }
}

/// All members of a kind, and then once each what is to be announced of them.
template<MemberKind kKind>
void swapMembers(Scene& scene, const SceneDelta& delta, DeltaDirection direction,
                 const Announce& announce)
{
    std::vector<SceneChange> changes;
    forEachMember([&]<class M>(const M&) {
        if constexpr (M::kind == kKind) {
            if constexpr (kKind == MemberKind::Entries) {
                swapEntries(M::of(scene), delta.of<M>(), direction);
            } else if constexpr (kKind == MemberKind::Table) {
                M::of(scene).apply(delta.of<M>(), direction == DeltaDirection::Undo);
            } else {
                swapValue(M::of(scene), delta.of<M>(), direction);
            }
            const bool isSaid = std::ranges::any_of(changes, [](const SceneChange& change) {
                return std::holds_alternative<typename M::Changed>(change);
            });
            if (hasChanged(delta.of<M>()) && !isSaid) {
                changes.push_back(typename M::Changed());
            }
        }
    });
    for (const SceneChange& change : changes) {
        announce(change);
    }
}

void swapColumns(Scene& scene, const SceneDelta& delta, DeltaDirection direction,
                 const Announce& announce)
{
    for (const ColumnDelta& change : delta.columns) {
        scene.population.setValues(change.column, change.ids,
                                   direction == DeltaDirection::Redo ? change.after
                                                                     : change.before);
    }
    for (const ColumnDelta& change : delta.columns) {
        announce(ColumnsChanged{change.ids, {change.column}});
    }
}

} // namespace

MemberSet SceneDelta::changedMembers() const
{
    MemberSet changed;
    forEachMember([&]<class M>(const M&) {
        if (hasChanged(of<M>())) {
            changed.add<M>();
        }
    });
    return changed;
}

bool SceneDelta::isEmpty() const
{
    return added.ids.empty() && removed.ids.empty() && columns.empty() &&
           changedMembers().isEmpty();
}

std::size_t SceneDelta::bulkBytes() const
{
    std::size_t total = added.bytes() + removed.bytes() + of<members::Relations>().bytes();
    for (const ColumnDelta& change : columns) {
        total += sizeof(ColumnDelta) + change.ids.size() * sizeof(IndividualId) +
                 change.before.size() + change.after.size();
    }
    return total;
}

std::size_t SceneDelta::bytes() const
{
    std::size_t total = sizeof(SceneDelta) + bulkBytes();
    forEachMember([&]<class M>(const M&) { total += deltaBytes(of<M>()); });
    return total;
}

void applyDelta(Scene& scene, const SceneDelta& delta, DeltaDirection direction,
                const Announce& announce)
{
    const bool isRedo = direction == DeltaDirection::Redo;
    // Entries first when they come and last when they go: nobody may lack his template meanwhile.
    if (isRedo) {
        swapMembers<MemberKind::Entries>(scene, delta, direction, announce);
    }
    scene.nextId = isRedo ? delta.nextIdAfter : delta.nextIdBefore;
    swapIndividuals(scene, isRedo ? delta.removed : delta.added,
                    isRedo ? delta.added : delta.removed, announce);
    swapColumns(scene, delta, direction, announce);
    if (!isRedo) {
        swapMembers<MemberKind::Entries>(scene, delta, direction, announce);
    }
    swapMembers<MemberKind::Value>(scene, delta, direction, announce);
    swapMembers<MemberKind::Table>(scene, delta, direction, announce);
}

} // namespace crowd::model
