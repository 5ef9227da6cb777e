// SPDX-License-Identifier: MIT
#include "model/states/StateKeeping.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "model/brush/ByteChange.h"
#include "model/population/Properties.h"
#include "model/template/Template.h"

namespace crowd::model {

namespace {

std::vector<StateTemplate> templatesOf(const Scene& scene, std::span<const TemplateId> used,
                                       ColumnSet columns)
{
    std::vector<StateTemplate> templates;
    for (const TemplateEntry& entry : scene.templates) {
        if (std::ranges::find(used, entry.id) != used.end()) {
            templates.push_back(rememberedTemplate(entry, columns));
        }
    }
    return templates;
}

} // namespace

ColumnSet withBothOfPlace(ColumnSet columns)
{
    if (columns.contains(ColumnId::Position) || columns.contains(ColumnId::Seat)) {
        columns.insert(ColumnId::Position);
        columns.insert(ColumnId::Seat);
    }
    return columns;
}

StateTemplate rememberedTemplate(const TemplateEntry& entry, ColumnSet columns)
{
    const auto holdsAny = [&columns](std::initializer_list<ColumnId> some) {
        return std::ranges::any_of(some, [&](ColumnId each) { return columns.contains(each); });
    };
    StateTemplate remembered;
    remembered.id = entry.id;
    if (holdsAny({ColumnId::Clip, ColumnId::WalkStyle})) {
        remembered.clips = entry.clipNames;
    }
    const bool hasTints = std::ranges::any_of(
        kTintColumns, [&columns](ColumnId tint) { return columns.contains(tint); });
    if (entry.asset &&
        (hasTints || holdsAny({ColumnId::MaterialChoices, ColumnId::TintReplaces}))) {
        for (std::size_t i = 0; i < std::min(entry.asset->slots.size(), kTintColumns.size()); ++i) {
            remembered.slots.push_back(entry.asset->slots[i].name);
        }
    }
    if (entry.asset && columns.contains(ColumnId::Parts)) {
        for (const auto& part : entry.asset->parts) {
            remembered.parts.push_back(part.name);
        }
    }
    return remembered;
}

ColumnSet usualStateColumns()
{
    ColumnSet columns;
    for (const PropertyAspectInfo& aspect : propertyAspects()) {
        if (!aspect.isWhoOrWhere) {
            columnsOf(aspect.aspect).forEach([&](ColumnId column) { columns.insert(column); });
        }
    }
    return columns;
}

ColumnSet columnsOf(PropertyAspect aspect)
{
    ColumnSet columns;
    for (const PropertyInfo& property : properties()) {
        if (property.traits.aspect == aspect) {
            columns.insert(property.id);
        }
    }
    return columns;
}

State keepState(const Scene& scene, std::string name, ColumnSet columns,
                std::span<const IndividualId> ids)
{
    State state;
    state.name = std::move(name);
    state.columns = withBothOfPlace(columns);
    IndividualRows rows =
        IndividualRows::withDefaults(std::vector<IndividualId>(ids.begin(), ids.end()));
    ColumnSet held = state.columns;
    held.insert(ColumnId::Template);
    held.forEach([&](ColumnId column) {
        rows.bytes[static_cast<std::size_t>(column)] = scene.population.values(column, ids);
    });
    state.templates = templatesOf(scene, rows.column(columns::templateId), state.columns);
    state.people = std::make_shared<const StoredRows>(rows);
    return state;
}

std::vector<IndividualId> peopleOf(const Scene& scene, const State& state,
                                   const std::vector<IndividualId>* ids)
{
    std::vector<IndividualId> people;
    std::ranges::set_intersection(state.people->ids, scene.population.ids(),
                                  std::back_inserter(people));
    if (ids != nullptr) {
        std::vector<IndividualId> meant;
        std::ranges::set_intersection(people, *ids, std::back_inserter(meant));
        people = std::move(meant);
    }
    return people;
}

State withColumns(const State& state, ColumnSet columns, const Scene& now)
{
    columns = withBothOfPlace(columns);
    State changed = state;
    bool hasMore = false;
    columns.forEach([&](ColumnId column) { hasMore |= !state.columns.contains(column); });
    if (hasMore) {
        Scene recalled = now; // what it holds of clips and slots goes by their names of today
        (void)recallState(recalled, state, state.columns);
        ColumnSet both = state.columns;
        columns.forEach([&both](ColumnId column) { both.insert(column); });
        const State whole = keepState(recalled, state.name, both, peopleOf(now, state));
        changed.templates = whole.templates;
        changed.people = whole.people;
        for (UnknownColumn& column : changed.unknownColumns) {
            std::erase_if(column.values, [&whole](const auto& value) {
                return !std::ranges::binary_search(whole.people->ids, value.first);
            });
        }
    }
    changed.columns = columns;
    StoredRows rows = *changed.people;
    std::erase_if(rows.columns, [&columns](const StoredRows::Column& each) {
        return each.column != ColumnId::Template && !columns.contains(each.column);
    });
    changed.people = std::make_shared<const StoredRows>(std::move(rows));
    return changed;
}

const State* findState(const Scene& scene, const std::string& name)
{
    const auto found = std::ranges::find(scene.states, name, &State::name);
    return found == scene.states.end() ? nullptr : &*found;
}

StateId freeStateId(const std::vector<State>& states, const Scene& scene)
{
    std::set<StateId> taken;
    for (const State& state : states) {
        taken.insert(state.id);
    }
    for (const Rule& rule : scene.rules) {
        const auto named = idsNamedIn(rule, FieldRole::State);
        taken.insert(named.begin(), named.end());
    }
    for (const Cue& cue : scene.cues) {
        taken.insert(cue.state);
    }
    for (const Mark& mark : scene.timeline) {
        taken.insert(mark.state);
    }
    StateId id = 1;
    while (taken.contains(id)) {
        ++id;
    }
    return id;
}

void putState(SceneEdit& edit, State state)
{
    std::vector<State> all = edit.scene().states;
    const auto same = std::ranges::find(all, state.name, &State::name);
    if (same != all.end()) {
        state.id = same->id;
        *same = std::move(state);
    } else {
        state.id = freeStateId(all, edit.scene());
        all.push_back(std::move(state));
    }
    edit.setStates(std::move(all));
}

} // namespace crowd::model
