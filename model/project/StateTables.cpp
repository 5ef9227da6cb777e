// SPDX-License-Identifier: MIT
#include "model/project/StateTables.h"

#include <algorithm>
#include <string>

#include <nlohmann/json.hpp>

#include "model/project/StatesJson.h"
#include "model/scene/SceneMembers.h"

namespace crowd::model {

using nlohmann::json;

bool areColumnNames(const json& names)
{
    return names.is_array() &&
           std::ranges::all_of(names, [](const json& name) { return name.is_string(); });
}

Result<void> StateTable::readHead(const json& object, std::size_t mostPeople)
{
    const json text = object.value("ids", json());
    if (!text.is_string() || !readIds(text.get<std::string>(), mostPeople, ids)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1.ids must be ascending numbers like "
                                                   "\"1-7,9\" and stand before the rows"),
                     rows.place()};
    }
    const json names = object.value("columns", json());
    if (!areColumnNames(names)) {
        return Error{
            QT_TRANSLATE_NOOP("Messages",
                              "%1.columns must be a list of names and stand before the rows"),
            rows.place()};
    }
    std::vector<std::string> columns{"id"};
    columns.insert(columns.end(), names.begin(), names.end());
    return rows.setColumns(columns);
}

Result<StateTable*> StateTables::begin(const TreeBuilder& header)
{
    const std::size_t state = header.root()[members::States::key].size() - 1;
    const std::string place = "states[" + std::to_string(state) + ']';
    if (!m_tables.empty() && m_tables.back()->state == state) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1.rows stands there twice"), place};
    }
    m_tables.push_back(std::make_unique<StateTable>(StateTable{state, RowParser(place, {}), {}}));
    return m_tables.back().get();
}

Result<void> StateTables::fill(Scene& scene)
{
    for (const std::unique_ptr<StateTable>& each : m_tables) {
        Result<RowParser::Table> table = each->rows.take();
        if (!table) {
            return table.error();
        }
        State& state = scene.states[each->state];
        state.people = std::make_shared<const StoredRows>(table.value().rows);
        state.unknownColumns = std::move(table.value().unknownColumns);
    }
    return {};
}

} // namespace crowd::model
