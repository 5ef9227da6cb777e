// SPDX-License-Identifier: MIT
#include "model/document/SceneDelta.h"

#include <algorithm>
#include <iterator>

namespace crowd::model {

namespace {

using Announce = std::function<void(const SceneChange&)>;

std::size_t bytesOf(const TemplateEntry& entry)
{
    std::size_t total = sizeof(entry) + entry.name.size() + entry.path.size() +
                        entry.problem.size() + entry.unknownMembers.size() +
                        entry.import.unknownMembers.size() +
                        entry.clipSpeeds.size() * sizeof(float) +
                        entry.clipRoles.size() * sizeof(std::optional<ClipRole>);
    for (const std::string& name : entry.clipNames) {
        total += sizeof(std::string) + name.size();
    }
    return total;
}

std::size_t bytesOf(const StageEntry& entry)
{
    return sizeof(entry) + entry.name.size() + entry.path.size() + entry.problem.size() +
           entry.unknownMembers.size();
}

std::size_t bytesOf(const std::vector<NamedCamera>& cameras)
{
    std::size_t total = 0;
    for (const NamedCamera& named : cameras) {
        total += sizeof(named) + named.name.size() + named.unknownMembers.size();
    }
    return total;
}

std::size_t bytesOf(const Lighting& lighting)
{
    return sizeof(lighting) + lighting.unknownMembers.size();
}

std::size_t bytesOf(const Place& place)
{
    return sizeof(place) + place.name.size() + place.unknownMembers.size();
}

std::size_t bytesOf(const Path& path)
{
    return sizeof(path) + path.name.size() + path.unknownMembers.size() +
           path.places.size() * sizeof(PlaceId) + path.branches.size() * sizeof(PathBranch);
}

/// Of a field, what lies outside its struct.
std::size_t bytesOutside(const FieldValue& value)
{
    if (const auto* text = std::get_if<std::string>(&value)) {
        return text->size();
    }
    const auto* clips = std::get_if<std::vector<ClipWeight>>(&value);
    return clips != nullptr ? clips->size() * sizeof(ClipWeight) : 0;
}

std::size_t bytesOf(const std::vector<Rule>& rules)
{
    std::size_t total = 0;
    for (const Rule& rule : rules) {
        total += sizeof(rule) + rule.name.size() + rule.unknownMembers.size() +
                 rule.conditions.size() * sizeof(Condition) + rule.actions.size() * sizeof(Action);
        forEachPart(rule, [&total](const RuleKind& kind, const void* object) {
            for (const FieldInfo& field : kind.fields) {
                total += bytesOutside(field.get(object));
            }
        });
    }
    return total;
}

/// Of entries with short texts.
template<class Named>
std::size_t bytesOfNames(const std::optional<ValueDelta<std::vector<Named>>>& names)
{
    return names ? (names->before.size() + names->after.size()) * sizeof(Named) : 0;
}

template<class Entry>
std::size_t bytesOf(const std::vector<EntryDelta<Entry>>& deltas)
{
    std::size_t total = 0;
    for (const EntryDelta<Entry>& delta : deltas) {
        total += delta.before ? bytesOf(*delta.before) : sizeof(Entry);
        total += delta.after ? bytesOf(*delta.after) : sizeof(Entry);
    }
    return total;
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

bool SceneDelta::isEmpty() const
{
    return added.ids.empty() && removed.ids.empty() && columns.empty() && templates.empty() &&
           stages.empty() && !cameras && !lighting && places.empty() && paths.empty() && !rules &&
           !tags && !numbers && !cues && !surface && !stepsPerSecond;
}

std::size_t SceneDelta::bulkBytes() const
{
    std::size_t total = added.bytes() + removed.bytes();
    for (const ColumnDelta& change : columns) {
        total += sizeof(ColumnDelta) + change.ids.size() * sizeof(IndividualId) +
                 change.before.size() + change.after.size();
    }
    return total;
}

std::size_t SceneDelta::bytes() const
{
    std::size_t total = sizeof(SceneDelta) + bulkBytes() + bytesOf(templates) + bytesOf(stages) +
                        bytesOf(places) + bytesOf(paths);
    if (cameras) {
        total += bytesOf(cameras->before) + bytesOf(cameras->after);
    }
    if (lighting) {
        total += bytesOf(lighting->before) + bytesOf(lighting->after);
    }
    if (rules) {
        total += bytesOf(rules->before) + bytesOf(rules->after);
    }
    return total + bytesOfNames(tags) + bytesOfNames(numbers) + bytesOfNames(cues);
}

void applyDelta(Scene& scene, const SceneDelta& delta, DeltaDirection direction,
                const Announce& announce)
{
    const bool isRedo = direction == DeltaDirection::Redo;
    // Templates first when they come and last when they go: nobody may lack his template meanwhile.
    const auto pathsAndPlaces = [&] {
        swapEntries(scene.places, delta.places, direction);
        swapEntries(scene.paths, delta.paths, direction);
        if (!delta.places.empty() || !delta.paths.empty()) {
            announce(PathsChanged{});
        }
    };
    const auto templatesAndStages = [&] {
        swapEntries(scene.templates, delta.templates, direction);
        swapEntries(scene.stages, delta.stages, direction);
        if (!delta.templates.empty()) {
            announce(TemplatesChanged{});
        }
        if (!delta.stages.empty()) {
            announce(StagesChanged{});
        }
    };
    if (isRedo) {
        templatesAndStages();
        pathsAndPlaces();
    }
    scene.nextId = isRedo ? delta.nextIdAfter : delta.nextIdBefore;
    swapIndividuals(scene, isRedo ? delta.removed : delta.added,
                    isRedo ? delta.added : delta.removed, announce);
    swapColumns(scene, delta, direction, announce);
    if (!isRedo) {
        pathsAndPlaces();
        templatesAndStages();
    }
    if (delta.cameras) {
        scene.cameras = isRedo ? delta.cameras->after : delta.cameras->before;
        announce(CamerasChanged{});
    }
    if (delta.lighting) {
        scene.lighting = isRedo ? delta.lighting->after : delta.lighting->before;
        announce(LightingChanged{});
    }
    if (delta.tags) {
        scene.tags = isRedo ? delta.tags->after : delta.tags->before;
    }
    if (delta.rules) {
        scene.rules = isRedo ? delta.rules->after : delta.rules->before;
    }
    if (delta.numbers) {
        scene.numbers = isRedo ? delta.numbers->after : delta.numbers->before;
    }
    if (delta.cues) {
        scene.cues = isRedo ? delta.cues->after : delta.cues->before;
    }
    if (delta.stepsPerSecond) {
        scene.stepsPerSecond = isRedo ? delta.stepsPerSecond->after : delta.stepsPerSecond->before;
    }
    if (delta.tags || delta.rules || delta.numbers || delta.cues || delta.stepsPerSecond) {
        announce(RulesChanged{});
    }
    if (delta.surface) {
        scene.surface = isRedo ? delta.surface->after : delta.surface->before;
        announce(PathsChanged{});
    }
}

} // namespace crowd::model
