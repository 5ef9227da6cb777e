// SPDX-License-Identifier: MIT
#include "model/brush/ByteChange.h"
#include "model/brush/ClipChoice.h"
#include "model/brush/ColumnWriting.h"
#include "model/states/StateKeeping.h"

namespace crowd::model {

namespace {

std::vector<ColumnId> restoredColumns(const RestoreSettings& settings)
{
    std::vector<ColumnId> restored;
    const auto add = [&restored](bool isOn, std::initializer_list<ColumnId> columns) {
        if (isOn) {
            restored.insert(restored.end(), columns);
        }
    };
    if (settings.colours) {
        restored.assign(kTintColumns.begin(), kTintColumns.end());
    }
    add(settings.colours, {ColumnId::TintReplaces});
    add(settings.materials, {ColumnId::MaterialChoices});
    add(settings.size, {ColumnId::Height, ColumnId::Girth});
    add(settings.clips, {ColumnId::PlaybackSpeed, ColumnId::Clip});
    add(settings.parts, {ColumnId::Parts});
    return restored;
}

/// Columns as somebody new has them, whatever the template.
void putDefaults(const ChangeRequest& request, std::span<const ColumnId> restored,
                 std::vector<IndividualId>& changed)
{
    const IndividualRows usual = IndividualRows::withDefaults({1});
    for (const ColumnId column : restored) {
        ByteChange change(request.edit.scene().population, column);
        forEachRow(request, [&](std::size_t, std::size_t row, IndividualId id) {
            change.set(id, row, usual.bytes[static_cast<std::size_t>(column)]);
        });
        change.apply(request.edit, changed);
    }
}

/// What depends on the template: `valueOf` gives it of an entry with an asset.
template<class T, class ValueOf>
void putOfTemplate(const ChangeRequest& request, ColumnKey<T> key, const ValueOf& valueOf,
                   std::vector<IndividualId>& changed)
{
    const Scene& scene = request.edit.scene();
    const auto templates = scene.population.column(columns::templateId);
    const auto now = scene.population.column(key);
    ColumnChange<T> change;
    forEachRow(request, [&](std::size_t, std::size_t row, IndividualId id) {
        const TemplateEntry* entry = scene.findTemplate(templates[row]);
        if (entry != nullptr && entry->asset) {
            change.set(id, now[row], valueOf(*entry, row));
        }
    });
    change.apply(request.edit, key, changed);
}

ChangeResult restoreTemplate(const ChangeRequest& request)
{
    const auto& settings = request.settings.as<RestoreSettings>();
    ChangeResult result;
    if (settings.clips) {
        const auto seats = request.edit.scene().population.column(columns::seat);
        putOfTemplate(
            request, columns::clip,
            [seats](const TemplateEntry& entry, std::size_t row) {
                return usualClip(entry, seats[row] != kNoSeat);
            },
            result.changed);
    }
    if (settings.parts) {
        putOfTemplate(
            request, columns::parts,
            [](const TemplateEntry& entry, std::size_t) { return defaultParts(*entry.asset); },
            result.changed);
    }
    std::vector<ColumnId> usual = restoredColumns(settings);
    std::erase(usual, ColumnId::Parts);
    std::erase(usual, ColumnId::Clip);
    putDefaults(request, usual, result.changed);
    return result;
}

const Population& peopleOf(const EarlierPeople& earlier, RestoreSource source)
{
    return source == RestoreSource::Created ? earlier.created
           : source == RestoreSource::Saved ? earlier.saved
                                            : earlier.before;
}

ChangeResult restoreEarlier(const ChangeRequest& request)
{
    const auto& settings = request.settings.as<RestoreSettings>();
    const Population source = peopleOf(request.edit.earlierPeople(), settings.source);
    const auto formerTemplates = source.column(columns::templateId);
    ChangeResult result;
    for (const ColumnId column : restoredColumns(settings)) {
        const Population& people = request.edit.scene().population;
        const auto templates = people.column(columns::templateId);
        ByteChange change(people, column);
        const ByteChange former(source, column);
        forEachRow(request, [&](std::size_t, std::size_t row, IndividualId id) {
            const std::size_t before = source.rowOf(id);
            if (before != Population::npos && formerTemplates[before] == templates[row]) {
                change.set(id, row, former.of(before));
            }
        });
        change.apply(request.edit, result.changed);
    }
    return result;
}

ColumnSet columnsOf(const RestoreSettings& settings, const State& state)
{
    if (settings.isWhole) {
        return state.columns;
    }
    ColumnSet columns;
    for (const ColumnId column : restoredColumns(settings)) {
        columns.insert(column);
    }
    if (columns.contains(ColumnId::Clip)) {
        columns.insert(ColumnId::Phase);
    }
    return columns;
}

ChangeResult restoreState(const ChangeRequest& request)
{
    const auto& settings = request.settings.as<RestoreSettings>();
    const auto& states = request.edit.scene().states;
    const auto found = std::ranges::find(states, settings.state, &State::id);
    if (found == states.end()) {
        return {{}, StrokeReason::NoState};
    }
    const State& state = *found;
    const std::vector<IndividualId> ids(request.ids.begin(), request.ids.end());
    StateRecall recall = giveBack(request.edit, state, columnsOf(settings, state), &ids);
    return {std::move(recall.changed), StrokeReason::Unchanged};
}

} // namespace

void RestoreSettings::prepare(BrushSettings& brush)
{
    brush.selection = BrushSelection::AllInCircle;
    brush.as<RestoreSettings>().source = RestoreSource::Created; // clothes have colours by then
}

ChangeResult RestoreSettings::change(const ChangeRequest& request)
{
    const auto& settings = request.settings.as<RestoreSettings>();
    if (settings.source == RestoreSource::State) {
        return restoreState(request);
    }
    ChangeResult result = settings.source == RestoreSource::Template ? restoreTemplate(request)
                                                                     : restoreEarlier(request);
    result.reason =
        restoredColumns(settings).empty() ? StrokeReason::NothingChosen : StrokeReason::Unchanged;
    return result;
}

} // namespace crowd::model
