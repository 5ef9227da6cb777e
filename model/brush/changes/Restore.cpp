// SPDX-License-Identifier: MIT
#include "model/brush/ByteChange.h"
#include "model/brush/ClipChoice.h"
#include "model/brush/ColumnWriting.h"

namespace crowd::model {

namespace {

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

} // namespace

void RestoreSettings::prepare(BrushSettings& brush)
{
    brush.selection = BrushSelection::AllInCircle;
}

ChangeResult RestoreSettings::change(const ChangeRequest& request)
{
    const auto& settings = request.settings.as<RestoreSettings>();
    ChangeResult result;
    std::vector<ColumnId> usual;
    if (settings.colours) {
        usual.assign(kTintColumns.begin(), kTintColumns.end());
        usual.push_back(ColumnId::TintReplaces);
    }
    if (settings.materials) {
        usual.push_back(ColumnId::MaterialChoices);
    }
    if (settings.size) {
        usual.insert(usual.end(), {ColumnId::Height, ColumnId::Girth});
    }
    if (settings.clips) {
        usual.push_back(ColumnId::PlaybackSpeed);
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
    putDefaults(request, usual, result.changed);
    const bool hasAny = !usual.empty() || settings.parts;
    result.reason = hasAny ? StrokeReason::Unchanged : StrokeReason::NothingChosen;
    return result;
}

} // namespace crowd::model
