// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "model/describe/FieldJson.h"
#include "model/project/JsonFields.h"
#include "model/scene/Scene.h"

/// Places, paths, what can be walked on, rules, tags, numbers and cues as optional members of the
/// project file's top-level object: what a scene does not have is not written, and files from
/// before there were any read as having none.
namespace crowd::model {

void writeEnvironment(const Scene& scene, nlohmann::json& top);
/// Problems name the member that is wrong.
void readEnvironment(JsonFields& top, Scene& scene, std::string& problem);

[[nodiscard]] nlohmann::json surfaceJson(const SurfaceSettings& surface);

void writeRules(const Scene& scene, nlohmann::json& top);
void readRules(JsonFields& top, Scene& scene, std::string& problem);

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
    fields.complain(key, "must be one of: " + all);
}

/// Calls read(fields, place) for each object of a list.
template<class Read>
void readObjects(JsonFields& fields, const char* key, const std::string& place,
                 std::string& problem, const Read& read)
{
    const nlohmann::json* list = fields.find(key);
    if (list == nullptr) {
        return;
    }
    if (!list->is_array()) {
        fields.complain(key, "must be a list");
        return;
    }
    for (std::size_t i = 0; i < list->size() && problem.empty(); ++i) {
        const std::string where = place + key + "[" + std::to_string(i) + "]";
        read(fields.part((*list)[i], where), where);
    }
}

} // namespace crowd::model
