// SPDX-License-Identifier: MIT
#include "model/project/StatesJson.h"

#include <charconv>

#include <nlohmann/json.hpp>

#include "model/population/Properties.h"
#include "model/project/JsonEntries.h"
#include "model/project/JsonWriting.h"
#include "model/project/ProjectHeader.h"

namespace crowd::model {

namespace {

using nlohmann::json;

json toJson(const StateTemplate& entry)
{
    json object = {{"id", entry.id}};
    const auto add = [&object](const char* key, const std::vector<std::string>& names) {
        if (!names.empty()) {
            object[key] = names;
        }
    };
    add("clips", entry.clips);
    add("slots", entry.slots);
    add("parts", entry.parts);
    return withUnknown(entry.unknownMembers, object);
}

json toJson(const State& state)
{
    json object = {{"id", state.id}, {"name", state.name}};
    json holds = json::array();
    state.columns.forEach([&holds](ColumnId column) { holds.push_back(columnInfo(column).name); });
    for (const std::string& unknown : state.unknownHolds) {
        holds.push_back(unknown);
    }
    object["holds"] = holds;
    json templates = json::array();
    for (const StateTemplate& each : state.templates) {
        templates.push_back(toJson(each));
    }
    object["templates"] = templates;
    return withUnknown(state.unknownMembers, object);
}

void readNames(JsonFields& fields, const char* key, std::vector<std::string>& names)
{
    const json* list = fields.find(key);
    if (list == nullptr) {
        return;
    }
    const bool areTexts = list->is_array() && std::ranges::all_of(*list, [](const json& each) {
                              return each.is_string();
                          });
    if (!areTexts) {
        fields.complain(key, QT_TRANSLATE_NOOP("Messages", "%1 must be a list of names"));
        return;
    }
    names = list->get<std::vector<std::string>>();
}

void readHolds(JsonFields& fields, State& state)
{
    std::vector<std::string> names;
    readNames(fields, "holds", names);
    for (const std::string& name : names) {
        if (const PropertyInfo* property = findProperty(name)) {
            state.columns.insert(property->id);
        } else {
            state.unknownHolds.push_back(name);
        }
    }
}

State readState(JsonFields fields, const std::string& place, Message& problem)
{
    State state;
    fields.require("id", state.id);
    fields.require("name", state.name);
    readHolds(fields, state);
    readObjects(fields, "templates", place + '.', problem,
                [&state](JsonFields entry, const std::string&) {
                    StateTemplate& read = state.templates.emplace_back();
                    entry.require("id", read.id);
                    readNames(entry, "clips", read.clips);
                    readNames(entry, "slots", read.slots);
                    readNames(entry, "parts", read.parts);
                    read.unknownMembers = entry.unknown();
                });
    sortById(state.templates, (place + ".templates").c_str(), problem);
    for (const char* table : {"ids", "columns", "rows"}) {
        (void)fields.find(table);
    }
    state.unknownMembers = fields.unknown();
    return state;
}

/// Digits up to whatever is none.
bool readNumber(const char*& at, const char* end, IndividualId& number)
{
    const auto read = std::from_chars(at, end, number);
    at = read.ptr;
    return read.ec == std::errc();
}

} // namespace

json memberJson(members::States, const Scene& scene)
{
    json list = json::array();
    for (const State& state : scene.states) {
        list.push_back(toJson(state));
    }
    return list;
}

void readMember(members::States, JsonFields& top, Scene& scene, Message& problem)
{
    readObjects(top, members::States::key, "", problem,
                [&](JsonFields fields, const std::string& place) {
                    scene.states.push_back(readState(std::move(fields), place, problem));
                });
    std::vector<State> byId = scene.states; // whose order is the artist's
    sortById(byId, members::States::key, problem);
}

std::string idsText(const std::vector<IndividualId>& ids)
{
    std::string text;
    for (std::size_t first = 0; first < ids.size();) {
        std::size_t last = first;
        while (last + 1 < ids.size() && ids[last + 1] == ids[last] + 1) {
            ++last;
        }
        text += (text.empty() ? "" : ",") + std::to_string(ids[first]);
        if (last > first) {
            text += '-' + std::to_string(ids[last]);
        }
        first = last + 1;
    }
    return text;
}

bool readIds(const std::string& text, std::size_t most, std::vector<IndividualId>& ids)
{
    const char* at = text.data();
    const char* end = at + text.size();
    while (at != end) {
        IndividualId first = 0;
        if (!readNumber(at, end, first)) {
            return false;
        }
        IndividualId last = first;
        if (at != end && *at == '-' && !readNumber(++at, end, last)) {
            return false;
        }
        const bool isSound = first > (ids.empty() ? 0 : ids.back()) && last >= first &&
                             last <= kMaxIndividualId && last - first < most - ids.size();
        if (!isSound || (at != end && *at++ != ',')) {
            return false;
        }
        for (IndividualId id = first; id <= last; ++id) {
            ids.push_back(id);
        }
    }
    return text.empty() || text.back() != ',';
}

} // namespace crowd::model
