// SPDX-License-Identifier: MIT
#include "widgets/docks/SelectedPeople.h"

#include <algorithm>

namespace crowd::widgets {

namespace {

/// Adds what is not there yet.
void join(std::vector<std::string>& names, const std::string& name)
{
    if (std::ranges::find(names, name) == names.end()) {
        names.push_back(name);
    }
}

template<class Items>
int indexOf(const Items& items, const std::string& name)
{
    const auto found =
        std::ranges::find_if(items, [&](const auto& item) { return item.name == name; });
    return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

} // namespace

int SelectedPeople::Group::slotIndex(const std::string& name) const
{
    const int slot = entry != nullptr && entry->asset ? entry->asset->slotIndex(name) : -1;
    return slot < model::kMaxTintSlots ? slot : -1;
}

int SelectedPeople::Group::choiceIndex(int slot, const std::string& name) const
{
    return indexOf(entry->asset->slots[static_cast<std::size_t>(slot)].choices, name);
}

int SelectedPeople::Group::partIndex(const std::string& name) const
{
    return entry != nullptr && entry->asset ? indexOf(entry->asset->parts, name) : -1;
}

int SelectedPeople::Group::clipIndex(const std::string& name) const
{
    if (entry == nullptr) {
        return -1;
    }
    const auto found = std::ranges::find(entry->clipNames, name);
    return found == entry->clipNames.end() ? -1
                                           : static_cast<int>(found - entry->clipNames.begin());
}

SelectedPeople::SelectedPeople(const model::Scene& scene, const Selection& selection)
    : m_scene(scene)
{
    const auto templates = scene.population.column(model::columns::templateId);
    std::vector<model::TemplateId> known;
    for (const model::IndividualId id : selection.ids()) {
        const std::size_t row = scene.population.rowOf(id);
        if (row == model::Population::npos) {
            continue;
        }
        m_rows.push_back(row);
        const auto found = std::ranges::find(known, templates[row]);
        const auto group = static_cast<std::size_t>(found - known.begin());
        if (found == known.end()) {
            known.push_back(templates[row]);
            m_groups.push_back({scene.findTemplate(templates[row]), {}});
        }
        m_groups[group].rows.push_back(row);
    }
}

std::vector<model::IndividualId> SelectedPeople::ids() const
{
    std::vector<model::IndividualId> ids;
    for (const std::size_t row : m_rows) {
        ids.push_back(m_scene.population.ids()[row]);
    }
    return ids;
}

std::vector<model::IndividualId> SelectedPeople::ids(const Group& group) const
{
    std::vector<model::IndividualId> ids;
    for (const std::size_t row : group.rows) {
        ids.push_back(m_scene.population.ids()[row]);
    }
    return ids;
}

std::vector<std::string> SelectedPeople::clips() const
{
    std::vector<std::string> names;
    for (const Group& group : m_groups) {
        for (std::size_t i = 0; group.entry != nullptr && i < group.entry->clipNames.size(); ++i) {
            join(names, group.entry->clipNames[i]);
        }
    }
    return names;
}

std::vector<std::string> SelectedPeople::slotNames() const
{
    std::vector<std::string> names;
    for (const Group& group : m_groups) {
        if (group.entry == nullptr || !group.entry->asset) {
            continue;
        }
        const auto& all = group.entry->asset->slots;
        for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), model::kMaxTintSlots); ++i) {
            join(names, all[i].name);
        }
    }
    return names;
}

std::vector<std::string> SelectedPeople::choices(const std::string& slot) const
{
    std::vector<std::string> names;
    for (const Group& group : m_groups) {
        const int index = group.slotIndex(slot);
        if (index >= 0) {
            const auto& all = group.entry->asset->slots[static_cast<std::size_t>(index)].choices;
            std::ranges::for_each(all, [&](const auto& choice) { join(names, choice.name); });
        }
    }
    return names;
}

std::vector<std::string> SelectedPeople::parts() const
{
    std::vector<std::string> names;
    for (const Group& group : m_groups) {
        if (group.entry != nullptr && group.entry->asset) {
            const auto& all = group.entry->asset->parts;
            std::ranges::for_each(all, [&](const auto& part) { join(names, part.name); });
        }
    }
    return names;
}

bool SelectedPeople::isTintable(const std::string& slot) const
{
    return std::ranges::any_of(m_groups, [&](const Group& group) {
        const int index = group.slotIndex(slot);
        return index >= 0 && group.entry->asset->slots[static_cast<std::size_t>(index)].tintable;
    });
}

} // namespace crowd::widgets
