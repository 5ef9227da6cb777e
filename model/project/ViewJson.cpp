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
    const Camera& camera = named.camera;
    json object = withUnknown(named.unknownMembers,
                              {{"name", named.name},
                               {"position", numbers(camera.position)},
                               {"orientation", numbers(camera.orientation)},
                               {"orthographic", camera.projection == Projection::Orthographic},
                               {"fovY", number(camera.fovYRadians)},
                               {"orthographicHeight", number(camera.orthographicHeight)},
                               {"pivotDistance", number(camera.pivotDistance)}});
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
    bool isOrthographic = false;
    fields.require("name", named.name);
    fields.require("position", named.camera.position);
    fields.require("orientation", named.camera.orientation);
    fields.read("orthographic", isOrthographic);
    fields.read("fovY", named.camera.fovYRadians);
    fields.read("orthographicHeight", named.camera.orthographicHeight);
    fields.read("pivotDistance", named.camera.pivotDistance);
    fields.read("look", named.look);
    named.camera.projection = isOrthographic ? Projection::Orthographic : Projection::Perspective;
    if (named.camera.fovYRadians <= 0.01F || named.camera.fovYRadians >= 3.1F) {
        fields.complain("fovY",
                        QT_TRANSLATE_NOOP("Messages", "%1 must lie between 0.01 and 3.1 radians"));
    }
    if (named.camera.orthographicHeight <= 0.0F || named.camera.pivotDistance <= 0.0F) {
        fields.complain(
            "", QT_TRANSLATE_NOOP("Messages", "%1 must have heights and distances above zero"));
    }
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
