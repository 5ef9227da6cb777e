// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "model/brush/ColumnWriting.h"
#include "model/brush/IndividualEdits.h"

namespace crowd::model {

namespace {

/// Of those that are chosen and loaded, in the order in which they are chosen.
std::vector<TemplateId> loadedTemplates(const Scene& scene, const TemplateSettings& settings)
{
    std::vector<TemplateId> loaded;
    for (const int id : settings.templates) {
        const TemplateEntry* entry = scene.findTemplate(static_cast<TemplateId>(id));
        if (entry != nullptr && entry->asset) {
            loaded.push_back(entry->id);
        }
    }
    return loaded;
}

} // namespace

void TemplateSettings::prepare(BrushSettings& brush)
{
    brush.selection = BrushSelection::AllInCircle;
    brush.op = BrushOperator::Random;
}

ChangeResult TemplateSettings::change(const ChangeRequest& request)
{
    const auto& settings = request.settings.as<TemplateSettings>();
    const Scene& scene = request.edit.scene();
    const std::vector<TemplateId> wanted = loadedTemplates(scene, settings);
    ChangeResult result;
    if (wanted.empty()) {
        result.reason = settings.templates.empty() ? StrokeReason::NothingChosen
                                                   : StrokeReason::TemplateNotLoaded;
        return result;
    }
    const auto shares = OperatorShares(request).of(request.settings.op, "template.template").shares;
    const auto now = scene.population.column(columns::templateId);
    std::map<TemplateId, std::vector<IndividualId>> becoming;
    forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId id) {
        const auto index = static_cast<std::size_t>(shares[i] * static_cast<double>(wanted.size()));
        const TemplateId target = wanted[std::min(index, wanted.size() - 1)];
        if (now[row] != target) {
            becoming[target].push_back(id);
            result.changed.push_back(id);
        }
    });
    for (const auto& [target, ids] : becoming) {
        changeTemplate(request.edit, ids, target);
    }
    result.reason = StrokeReason::Unchanged;
    return result;
}

std::string TemplateSettings::take(BrushSettings& brush, const TakenFrom& from)
{
    brush.as<TemplateSettings>().templates = {static_cast<int>(from.entry.id)};
    return from.entry.name;
}

} // namespace crowd::model
