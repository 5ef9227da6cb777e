// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "model/base/Random.h"
#include "model/brush/ByteChange.h"
#include "model/brush/ColumnWriting.h"

namespace crowd::model {

namespace {

/// What goes from one to another together, and what keys its permutation.
struct Exchange
{
    bool ShuffleSettings::*isOn;
    const char* draw;
    std::vector<ColumnId> columns;
};

const std::vector<Exchange>& exchanges()
{
    static const std::vector<Exchange> kAll = [] {
        std::vector<ColumnId> colours(kTintColumns.begin(), kTintColumns.end());
        colours.insert(colours.end(),
                       {ColumnId::TintReplaces, ColumnId::MaterialChoices, ColumnId::Parts});
        return std::vector<Exchange>{
            {&ShuffleSettings::colours, "shuffle.colours", std::move(colours)},
            {&ShuffleSettings::size, "shuffle.size", {ColumnId::Height, ColumnId::Girth}},
            {&ShuffleSettings::heading, "shuffle.heading", {ColumnId::Heading}},
            {&ShuffleSettings::timing,
             "shuffle.timing",
             {ColumnId::Phase, ColumnId::PlaybackSpeed}},
            {&ShuffleSettings::clips, "shuffle.clips", {ColumnId::Clip}}};
    }();
    return kAll;
}

/// For each of the request's individuals, in their order, from whose row he takes over: a
/// permutation within each template.
std::vector<std::size_t> takenFrom(const ChangeRequest& request, const char* draw)
{
    const Population& people = request.edit.scene().population;
    const auto templates = people.column(columns::templateId);
    std::map<TemplateId, std::vector<std::size_t>> alike; ///< indices of the request
    forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId) {
        alike[templates[row]].push_back(i);
    });
    std::vector<std::size_t> from(request.ids.size());
    const std::uint64_t key = hashKeys(request.seed, hashText(draw));
    for (const auto& [id, members] : alike) {
        std::vector<std::size_t> order = members;
        std::ranges::sort(order, {}, [&](std::size_t i) {
            return std::pair(hashKeys(key, request.ids[i]), request.ids[i]);
        });
        for (std::size_t k = 0; k < members.size(); ++k) {
            from[members[k]] = people.rowOf(request.ids[order[k]]);
        }
    }
    return from;
}

} // namespace

void ShuffleSettings::prepare(BrushSettings& brush)
{
    brush.selection = BrushSelection::AllInCircle;
}

ChangeResult ShuffleSettings::change(const ChangeRequest& request)
{
    const auto& settings = request.settings.as<ShuffleSettings>();
    // As everybody is now: what one has taken over is not taken from him.
    const Population before = request.edit.scene().population;
    ChangeResult result;
    bool hasAny = false;
    for (const Exchange& exchange : exchanges()) {
        if (!(settings.*exchange.isOn)) {
            continue;
        }
        hasAny = true;
        const std::vector<std::size_t> from = takenFrom(request, exchange.draw);
        for (const ColumnId column : exchange.columns) {
            ByteChange change(before, column);
            forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId id) {
                change.set(id, row, change.of(from[i]));
            });
            change.apply(request.edit, result.changed);
        }
    }
    result.reason = hasAny ? StrokeReason::Unchanged : StrokeReason::NothingChosen;
    return result;
}

} // namespace crowd::model
