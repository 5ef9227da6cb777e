// SPDX-License-Identifier: MIT
#include "model/project/ViewJson.h"

#include <nlohmann/json.hpp>

#include "model/describe/FieldJson.h"
#include "model/project/JsonWriting.h"

namespace crowd::model {

namespace {

using nlohmann::json;

json toJson(const NamedCamera& named)
{
    json object = withUnknown(named.unknownMembers, {{"name", named.name}});
    addFields(object, fieldsOf<Camera>(), &named.camera);
    if (named.look != 0) {
        object["look"] = named.look;
    }
    return object;
}

json toJson(const Lighting& light)
{
    json object = withUnknown(light.unknownMembers, json::object());
    addFields(object, fieldsOf<Lighting>(), &light);
    return object;
}

NamedCamera cameraFrom(JsonFields fields)
{
    NamedCamera named;
    fields.require("name", named.name);
    fields.require("position", named.camera.position);
    fields.require("orientation", named.camera.orientation);
    readFields(fields, fieldsOf<Camera>(), &named.camera);
    fields.read("look", named.look);
    named.unknownMembers = fields.unknown();
    return named;
}

Lighting lightingFrom(JsonFields fields)
{
    Lighting light;
    readFields(fields, fieldsOf<Lighting>(), &light);
    light.unknownMembers = fields.unknown();
    return light;
}

LookPreset lookFrom(JsonFields fields, const Looks& others)
{
    LookPreset look;
    readFields(fields, fieldsOf<LookPreset>(), &look);
    if (look.name.empty()) {
        fields.complain("name", QT_TRANSLATE_NOOP("Messages", "%1 must not be empty"));
    } else if (findLook(others, look.name) != nullptr) {
        fields.complain("name", QT_TRANSLATE_NOOP("Messages", "%1 is that of another look"));
    }
    look.unknownMembers = fields.unknown();
    return look;
}

} // namespace

json memberJson(members::Cameras, const Scene& scene)
{
    json list = json::array();
    for (const NamedCamera& named : scene.cameras) {
        list.push_back(toJson(named));
    }
    return list;
}

void readMember(members::Cameras, JsonFields& top, Scene& scene, Message& problem)
{
    readObjects(top, "cameras", "", problem, [&scene](JsonFields fields, const std::string&) {
        scene.cameras.push_back(cameraFrom(std::move(fields)));
    });
}

void readMember(members::Looks, JsonFields& top, Scene& scene, Message& problem)
{
    const char* key = members::Looks::key;
    readObjects(top, key, "", problem, [&scene](JsonFields fields, const std::string&) {
        scene.looks.push_back(lookFrom(std::move(fields), scene.looks));
    });
    Looks byId = scene.looks;
    sortById(byId, key, problem);
    if (scene.looks.size() > kMostLooks && problem.empty()) {
        problem = {QT_TRANSLATE_NOOP("Messages", "%1: a scene has at most %2 looks"), key,
                   kMostLooks};
    }
}

json memberJson(members::Light, const Scene& scene)
{
    return toJson(scene.lighting);
}

void readMember(members::Light, JsonFields& top, Scene& scene, Message&)
{
    const json* lighting = top.find("lighting");
    scene.lighting = lighting != nullptr ? lightingFrom(top.part(*lighting, "lighting"))
                                         : Lighting(); // as files that say nothing always were
}

} // namespace crowd::model
