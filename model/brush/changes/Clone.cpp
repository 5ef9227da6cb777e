// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "model/brush/ByteChange.h"
#include "model/brush/ColumnWriting.h"
#include "model/brush/IndividualEdits.h"

namespace crowd::model {

namespace {

/// Of the columns those that the settings choose, but for the template.
std::vector<ColumnId> chosenColumns(const CloneSettings& settings)
{
    std::vector<ColumnId> chosen;
    const auto add = [&chosen](bool isOn, std::initializer_list<ColumnId> columns) {
        if (isOn) {
            chosen.insert(chosen.end(), columns);
        }
    };
    if (settings.looks) {
        chosen.assign(kTintColumns.begin(), kTintColumns.end());
    }
    add(settings.looks, {ColumnId::TintReplaces, ColumnId::MaterialChoices, ColumnId::Parts});
    add(settings.size, {ColumnId::Height, ColumnId::Girth});
    add(settings.heading, {ColumnId::Heading});
    add(settings.clips, {ColumnId::Clip});
    add(settings.timing, {ColumnId::Phase, ColumnId::PlaybackSpeed});
    add(settings.walking, {ColumnId::Path, ColumnId::WalkSpeed, ColumnId::WalkStyle});
    add(settings.tags, {ColumnId::Tags});
    add(settings.group, {ColumnId::Group});
    return chosen;
}

/// Those who are of another template than the source become of its.
void copyTemplate(const ChangeRequest& request, TemplateId target,
                  std::vector<IndividualId>& changed)
{
    const auto templates = request.edit.scene().population.column(columns::templateId);
    forEachRow(request, [&](std::size_t, std::size_t row, IndividualId id) {
        if (templates[row] != target) {
            changed.push_back(id);
        }
    });
    if (!changed.empty()) {
        changeTemplate(request.edit, changed, target);
    }
}

/// The source as it would be of each template, made once.
class SourceRows
{
public:
    SourceRows(const Scene& scene, IndividualId source)
        : m_scene(scene), m_source(scene.population.rows(std::array{source}))
    {
    }
    const IndividualRows& of(TemplateId id)
    {
        const auto [found, isNew] = m_rows.try_emplace(id, m_source);
        const TemplateEntry* entry = m_scene.findTemplate(id);
        if (isNew && entry != nullptr && entry->asset) {
            toTemplate(m_scene, found->second, *entry);
        }
        return found->second;
    }

private:
    const Scene& m_scene;
    IndividualRows m_source;
    std::map<TemplateId, IndividualRows> m_rows;
};

} // namespace

ChangeResult CloneSettings::change(const ChangeRequest& request)
{
    const auto& settings = request.settings.as<CloneSettings>();
    const Population& people = request.edit.scene().population;
    const std::size_t source = people.rowOf(settings.source);
    ChangeResult result;
    if (source == Population::npos) {
        result.reason = StrokeReason::NobodyChosen;
        return result;
    }
    if (settings.templateToo) {
        copyTemplate(request, people.column(columns::templateId)[source], result.changed);
    }
    const auto templates = people.column(columns::templateId);
    SourceRows rows(request.edit.scene(), settings.source);
    const std::vector<ColumnId> chosen = chosenColumns(settings);
    for (const ColumnId column : chosen) {
        ByteChange change(people, column);
        forEachRow(request, [&](std::size_t, std::size_t row, IndividualId id) {
            change.set(id, row, rows.of(templates[row]).bytes[static_cast<std::size_t>(column)]);
        });
        change.apply(request.edit, result.changed);
    }
    result.reason = chosen.empty() && !settings.templateToo ? StrokeReason::NothingChosen
                                                            : StrokeReason::Unchanged;
    return result;
}

std::string CloneSettings::take(BrushSettings& brush, const TakenFrom& from)
{
    brush.as<CloneSettings>().source = from.id;
    return from.entry.name;
}

} // namespace crowd::model
