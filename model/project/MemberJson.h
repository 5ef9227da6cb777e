// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "model/project/AssetsJson.h"
#include "model/project/EnvironmentJson.h"
#include "model/project/FeaturesJson.h"
#include "model/project/JsonWriting.h"
#include "model/project/RelationsJson.h"
#include "model/project/RulesJson.h"
#include "model/project/StatesJson.h"
#include "model/project/ViewJson.h"

/// The members of a scene (see SceneMembers.h) as members of the project file's top-level object.
/// Each is written and read by overloads of memberJson() and readMember() for it; those whose type
/// is described by fields, or a list of such, need none. Problems name the member that is wrong.
namespace crowd::model {

template<Described T>
[[nodiscard]] nlohmann::json describedJson(const T& value)
{
    nlohmann::json object = withUnknown(value.unknownMembers, nlohmann::json::object());
    addFields(object, fieldsOf<T>(), &value);
    return object;
}
template<Described T>
void readDescribed(JsonFields fields, T& value)
{
    readFields(fields, fieldsOf<T>(), &value);
    value.unknownMembers = fields.unknown();
}

/// A described struct, as an object.
template<class M>
requires Described<typename M::Type>
[[nodiscard]] nlohmann::json memberJson(M, const Scene& scene)
{
    return describedJson(M::of(scene));
}
template<class M>
requires Described<typename M::Type>
void readMember(M, JsonFields& top, Scene& scene, Message&)
{
    if (const nlohmann::json* object = top.find(M::key)) {
        readDescribed(top.part(*object, M::key), M::of(scene));
    }
}

/// Described entries with ids, as a list of objects.
template<class M>
requires Described<typename M::Type::value_type>
[[nodiscard]] nlohmann::json memberJson(M, const Scene& scene)
{
    nlohmann::json list = nlohmann::json::array();
    for (const auto& entry : M::of(scene)) {
        list.push_back(describedJson(entry));
    }
    return list;
}
template<class M>
requires Described<typename M::Type::value_type>
void readMember(M, JsonFields& top, Scene& scene, Message& problem)
{
    readObjects(top, M::key, "", problem, [&scene](JsonFields fields, const std::string&) {
        readDescribed(std::move(fields), M::of(scene).emplace_back());
    });
    sortById(M::of(scene), M::key, problem);
}

/// What a scene has by default of its environment is not written, and files from before there was
/// such a member read as having none.
void writeMembers(const Scene& scene, nlohmann::json& top);
void readMembers(JsonFields& top, Scene& scene, Message& problem);

} // namespace crowd::model
