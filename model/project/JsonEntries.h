// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <string>
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
[[nodiscard]] inline Message idProblem(const char* key, std::uint32_t id)
{
    return id == 0
               ? Message(QT_TRANSLATE_NOOP("Messages", "%1: the id %2 is not allowed"), key, id)
               : Message(QT_TRANSLATE_NOOP("Messages", "%1: the id %2 is given twice"), key, id);
}

/// Entries ascend by id, which is neither 0 nor given twice.
template<class Entry>
void sortById(std::vector<Entry>& entries, const char* key, Message& problem)
{
    std::ranges::sort(entries, {}, &Entry::id);
    for (std::size_t i = 0; i < entries.size() && problem.empty(); ++i) {
        if (entries[i].id == 0 || (i > 0 && entries[i].id == entries[i - 1].id)) {
            problem = idProblem(key, entries[i].id);
        }
    }
}

} // namespace crowd::model
