// SPDX-License-Identifier: MIT
#include "model/project/AssetsJson.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "model/describe/FieldJson.h"
#include "model/project/JsonWriting.h"

namespace crowd::model {

namespace {

using nlohmann::json;

json toJson(const ImportSettings& settings)
{
    json object = withUnknown(settings.unknownMembers, json::object());
    addFields(object, fieldsOf<ImportSettings>(), &settings);
    return object;
}

json toJson(const TemplateEntry& entry)
{
    json object = {{"id", entry.id}, {"name", entry.name}, {"path", entry.path}};
    object["clips"] = entry.clipNames;
    if (!(entry.import == ImportSettings{})) {
        object["import"] = toJson(entry.import);
    }
    if (std::ranges::any_of(entry.clipSpeeds, [](float speed) { return !std::isnan(speed); })) {
        json speeds = json::array();
        for (const float speed : entry.clipSpeeds) {
            speeds.push_back(std::isnan(speed) ? json(nullptr) : number(speed));
        }
        object["clipSpeeds"] = speeds;
    }
    if (std::ranges::any_of(entry.clipRoles, [](const auto& role) { return role.has_value(); })) {
        json roles = json::array();
        for (const std::optional<ClipRole>& role : entry.clipRoles) {
            roles.push_back(role ? json(keyOf(*role)) : json(nullptr));
        }
        object["clipRoles"] = roles;
    }
    return withUnknown(entry.unknownMembers, object);
}

json toJson(const StageEntry& entry)
{
    json object = withUnknown(entry.unknownMembers,
                              {{"id", entry.id}, {"name", entry.name}, {"path", entry.path}});
    addFields(object, fieldsOf<StageEntry>(), &entry);
    return object;
}

ImportSettings readImport(JsonFields fields)
{
    ImportSettings settings;
    readFields(fields, fieldsOf<ImportSettings>(), &settings);
    settings.unknownMembers = fields.unknown();
    return settings;
}

void requirePath(JsonFields& fields, std::string& path)
{
    fields.require("path", path);
    if (path.empty()) {
        fields.complain("path", QT_TRANSLATE_NOOP("Messages", "%1 must not be empty"));
    }
}

void readClips(JsonFields& fields, TemplateEntry& entry)
{
    if (const json* clips = fields.find("clips")) {
        if (!clips->is_array() ||
            !std::ranges::all_of(*clips, [](const json& name) { return name.is_string(); })) {
            fields.complain("clips", QT_TRANSLATE_NOOP("Messages", "%1 must be a list of names"));
            return;
        }
        entry.clipNames = clips->get<std::vector<std::string>>();
    }
    const json* speeds = fields.find("clipSpeeds");
    if (speeds == nullptr) {
        return;
    }
    if (!speeds->is_array() || !std::ranges::all_of(*speeds, [](const json& speed) {
            return JsonFields::isFinite(speed) || speed.is_null();
        })) {
        fields.complain(
            "clipSpeeds",
            QT_TRANSLATE_NOOP("Messages", "%1 must be a list of finite numbers or null"));
        return;
    }
    for (const json& speed : *speeds) {
        entry.clipSpeeds.push_back(speed.is_null() ? std::numeric_limits<float>::quiet_NaN()
                                                   : speed.get<float>());
    }
}

/// Roles that a later version knows count as chosen by nobody.
void readRoles(JsonFields& fields, TemplateEntry& entry)
{
    const json* roles = fields.find("clipRoles");
    if (roles == nullptr) {
        return;
    }
    if (!roles->is_array() || !std::ranges::all_of(*roles, [](const json& role) {
            return role.is_string() || role.is_null();
        })) {
        fields.complain("clipRoles",
                        QT_TRANSLATE_NOOP("Messages", "%1 must be a list of words or null"));
        return;
    }
    for (const json& role : *roles) {
        entry.clipRoles.push_back(role.is_string() ? clipRoleOf(role.get<std::string>())
                                                   : std::nullopt);
    }
}

TemplateEntry templateFrom(JsonFields fields, const std::string& place, Message& problem)
{
    TemplateEntry entry;
    fields.require("id", entry.id);
    requirePath(fields, entry.path);
    fields.read("name", entry.name);
    readClips(fields, entry);
    readRoles(fields, entry);
    if (const json* settings = fields.find("import")) {
        entry.import = readImport(JsonFields(*settings, place + ".import", problem));
    }
    entry.unknownMembers = fields.unknown();
    return entry;
}

StageEntry stageFrom(JsonFields fields)
{
    StageEntry entry;
    fields.require("id", entry.id);
    requirePath(fields, entry.path);
    fields.read("name", entry.name);
    readFields(fields, fieldsOf<StageEntry>(), &entry);
    entry.unknownMembers = fields.unknown();
    return entry;
}

} // namespace

json memberJson(members::Templates, const Scene& scene)
{
    json list = json::array();
    for (const TemplateEntry& entry : scene.templates) {
        list.push_back(toJson(entry));
    }
    return list;
}

void readMember(members::Templates, JsonFields& top, Scene& scene, Message& problem)
{
    readObjects(top, "templates", "", problem, [&](JsonFields fields, const std::string& place) {
        scene.templates.push_back(templateFrom(std::move(fields), place, problem));
    });
    sortById(scene.templates, "templates", problem);
}

json memberJson(members::Stages, const Scene& scene)
{
    json list = json::array();
    for (const StageEntry& entry : scene.stages) {
        list.push_back(toJson(entry));
    }
    return list;
}

void readMember(members::Stages, JsonFields& top, Scene& scene, Message& problem)
{
    readObjects(top, "stages", "", problem, [&scene](JsonFields fields, const std::string&) {
        scene.stages.push_back(stageFrom(std::move(fields)));
    });
    sortById(scene.stages, "stages", problem);
}

} // namespace crowd::model
