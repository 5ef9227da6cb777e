// SPDX-License-Identifier: MIT
#include "model/states/StateKeeping.h"

#include <algorithm>
#include <iterator>

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

const State* findState(const Scene& scene, const std::string& name)
{
    const auto found = std::ranges::find(scene.states, name, &State::name);
    return found == scene.states.end() ? nullptr : &*found;
}

StateId freeStateId(const std::vector<State>& states)
{
    StateId id = 1;
    while (std::ranges::find(states, id, &State::id) != states.end()) {
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
        state.id = freeStateId(all);
        all.push_back(std::move(state));
    }
    edit.setStates(std::move(all));
}

} // namespace crowd::model
