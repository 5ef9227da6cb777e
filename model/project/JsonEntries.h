// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/describe/FieldJson.h"
#include "model/project/JsonFields.h"

/// What the members of project files have in common: lists of objects, ids, names of choices.
namespace crowd::model {

/// A choice among names; complains with all of them.
template<std::size_t N, class Enum>
void readName(JsonFields& fields, const char* key, const std::array<const char*, N>& names,
              Enum& value)
{
    std::string text = names[static_cast<std::size_t>(value)];
    fields.read(key, text);
    for (std::size_t i = 0; i < N; ++i) {
        if (text == names[i]) {
            value = static_cast<Enum>(i);
            return;
        }
    }
    std::string all;
    for (const char* name : names) {
        all += (all.empty() ? "" : ", ") + std::string(name);
    }
    fields.complain(key, QT_TRANSLATE_NOOP("Messages", "%1 must be one of: %2"), all);
}

/// Calls read(fields, place) for each object of a list.
template<class Read>
void readObjects(JsonFields& fields, const char* key, const std::string& place, Message& problem,
                 const Read& read)
{
    const nlohmann::json* list = fields.find(key);
    if (list == nullptr) {
        return;
    }
    if (!list->is_array()) {
        fields.complain(key, QT_TRANSLATE_NOOP("Messages", "%1 must be a list"));
        return;
    }
    for (std::size_t i = 0; i < list->size() && problem.empty(); ++i) {
        const std::string where = place + key + "[" + std::to_string(i) + "]";
        read(fields.part((*list)[i], where), where);
    }
}

/// Of an id that is 0 or given twice.
[[nodiscard]] Message idProblem(const char* key, std::uint32_t id);
/// Indices in the order of ids, of which none is 0 or given twice; else the problem says so.
[[nodiscard]] std::vector<std::size_t> orderOfIds(const std::vector<std::uint32_t>& ids,
                                                  const char* key, Message& problem);

/// Entries ascend by id, which is neither 0 nor given twice.
template<class Entry>
void sortById(std::vector<Entry>& entries, const char* key, Message& problem)
{
    std::vector<std::uint32_t> ids; // not the entries: to sort each kind of them is much to compile
    ids.reserve(entries.size());
    for (const Entry& entry : entries) {
        ids.push_back(entry.id);
    }
    std::vector<Entry> ordered;
    ordered.reserve(entries.size());
    for (const std::size_t index : orderOfIds(ids, key, problem)) {
        ordered.push_back(std::move(entries[index]));
    }
    entries = std::move(ordered);
}

} // namespace crowd::model
