// SPDX-License-Identifier: MIT
#include "behavior/agents/TemplateTables.h"

#include <algorithm>

#include "model/brush/ClipChoice.h"

namespace crowd::behavior {

void TemplateTables::read(const Entries& entries)
{
    m_entries = std::make_shared<const Entries>(entries);
    m_facts.clear();
    for (const model::TemplateEntry& entry : *m_entries) {
        Facts& facts = m_facts.emplace_back(
            Facts{GaitTable(entry), std::vector<ClipFacts>(entry.clipNames.size()),
                  entry.asset ? entry.asset->footprint : model::Footprint{},
                  model::usualWalkingSpeed(entry)});
        for (std::size_t i = 0; i < facts.clips.size() && entry.asset; ++i) {
            const int index = entry.asset->clipIndex(entry.clipNames[i]);
            if (index >= 0) {
                const model::Clip& clip = entry.asset->clips[static_cast<std::size_t>(index)];
                facts.clips[i] = {clip.seconds, clip.loop, facts.gaits.isMover(i)};
            }
        }
    }
}

std::uint32_t TemplateTables::indexOf(model::TemplateId id) const
{
    const auto entry = std::ranges::find(*m_entries, id, &model::TemplateEntry::id);
    return static_cast<std::uint32_t>(entry - m_entries->begin());
}

const TemplateTables::ClipFacts* TemplateTables::clip(std::uint32_t table, int clip) const
{
    if (!has(table) || clip < 0 || static_cast<std::size_t>(clip) >= m_facts[table].clips.size()) {
        return nullptr;
    }
    return &m_facts[table].clips[static_cast<std::size_t>(clip)];
}

int TemplateTables::clipNamed(std::uint32_t table, std::string_view name) const
{
    if (!has(table)) {
        return -1;
    }
    const std::vector<std::string>& names = (*m_entries)[table].clipNames;
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

const model::Footprint& TemplateTables::footprint(std::uint32_t table) const
{
    static const model::Footprint kPerson;
    return has(table) ? m_facts[table].footprint : kPerson;
}

float TemplateTables::usualSpeed(std::uint32_t table) const
{
    return has(table) ? m_facts[table].usualSpeed : model::kUsualWalkingSpeed;
}

std::uint32_t TemplateTables::gaitOfStyle(std::uint32_t table, std::uint16_t walkStyle) const
{
    return walkStyle == 0 || !has(table)
               ? 0
               : static_cast<std::uint32_t>(m_facts[table].gaits.gaitOf(walkStyle - 1U));
}

} // namespace crowd::behavior
