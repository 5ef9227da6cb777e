// SPDX-License-Identifier: MIT
#include "model/project/ProjectHeader.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include <nlohmann/json.hpp>

#include "model/project/EnvironmentJson.h"
#include "model/project/JsonFields.h"
#include "model/project/JsonWriting.h"

namespace crowd::model {

namespace {

using nlohmann::json;

json toJson(const ImportSettings& settings)
{
    return withUnknown(settings.unknownMembers, {{"scale", number(settings.scale)},
                                                 {"rotation", numbers(settings.rotation)},
                                                 {"groundOffset", number(settings.groundOffset)},
                                                 {"removeRootMotion", settings.removeRootMotion}});
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
    return withUnknown(entry.unknownMembers, {{"id", entry.id},
                                              {"name", entry.name},
                                              {"path", entry.path},
                                              {"position", numbers(entry.position)},
                                              {"heading", number(entry.headingRadians)},
                                              {"scale", number(entry.scale)}});
}

json toJson(const NamedCamera& named)
{
    const Camera& camera = named.camera;
    return withUnknown(named.unknownMembers,
                       {{"name", named.name},
                        {"position", numbers(camera.position)},
                        {"orientation", numbers(camera.orientation)},
                        {"orthographic", camera.projection == Projection::Orthographic},
                        {"fovY", number(camera.fovYRadians)},
                        {"orthographicHeight", number(camera.orthographicHeight)},
                        {"pivotDistance", number(camera.pivotDistance)}});
}

json toJson(const Lighting& light)
{
    return withUnknown(light.unknownMembers, {{"sunAzimuth", number(light.sunAzimuthRadians)},
                                              {"sunElevation", number(light.sunElevationRadians)},
                                              {"sunColor", numbers(light.sunColor)},
                                              {"sunStrength", number(light.sunStrength)},
                                              {"ambientColor", numbers(light.ambientColor)},
                                              {"ambientStrength", number(light.ambientStrength)},
                                              {"skyZenith", numbers(light.skyZenith)},
                                              {"skyHorizon", numbers(light.skyHorizon)},
                                              {"ground", numbers(light.ground)},
                                              {"groundGrid", light.showGroundGrid}});
}

template<class Item>
json listToJson(const std::vector<Item>& items)
{
    json list = json::array();
    for (const Item& item : items) {
        list.push_back(toJson(item));
    }
    return list;
}

ImportSettings readImport(JsonFields fields)
{
    ImportSettings settings;
    fields.read("scale", settings.scale);
    fields.read("rotation", settings.rotation);
    fields.read("groundOffset", settings.groundOffset);
    fields.read("removeRootMotion", settings.removeRootMotion);
    if (settings.scale <= 0.0F) {
        fields.complain("scale", "must be above zero");
    }
    settings.unknownMembers = fields.unknown();
    return settings;
}

void requirePath(JsonFields& fields, std::string& path)
{
    fields.require("path", path);
    if (path.empty()) {
        fields.complain("path", "must not be empty");
    }
}

void readClips(JsonFields& fields, TemplateEntry& entry)
{
    if (const json* clips = fields.find("clips")) {
        if (!clips->is_array() ||
            !std::ranges::all_of(*clips, [](const json& name) { return name.is_string(); })) {
            fields.complain("clips", "must be a list of names");
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
        fields.complain("clipSpeeds", "must be a list of finite numbers or null");
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
        fields.complain("clipRoles", "must be a list of words or null");
        return;
    }
    for (const json& role : *roles) {
        entry.clipRoles.push_back(role.is_string() ? clipRoleOf(role.get<std::string>())
                                                   : std::nullopt);
    }
}

void readItem(JsonFields fields, TemplateEntry& entry, const std::string& place,
              std::string& problem)
{
    fields.require("id", entry.id);
    requirePath(fields, entry.path);
    fields.read("name", entry.name);
    readClips(fields, entry);
    readRoles(fields, entry);
    if (const json* settings = fields.find("import")) {
        entry.import = readImport(JsonFields(*settings, place + ".import", problem));
    }
    entry.unknownMembers = fields.unknown();
}

void readItem(JsonFields fields, StageEntry& entry, const std::string&, std::string&)
{
    fields.require("id", entry.id);
    requirePath(fields, entry.path);
    fields.read("name", entry.name);
    fields.read("position", entry.position);
    fields.read("heading", entry.headingRadians);
    fields.read("scale", entry.scale);
    if (entry.scale <= 0.0F) {
        fields.complain("scale", "must be above zero");
    }
    entry.unknownMembers = fields.unknown();
}

void readItem(JsonFields fields, NamedCamera& named, const std::string&, std::string&)
{
    bool isOrthographic = false;
    fields.require("name", named.name);
    fields.require("position", named.camera.position);
    fields.require("orientation", named.camera.orientation);
    fields.read("orthographic", isOrthographic);
    fields.read("fovY", named.camera.fovYRadians);
    fields.read("orthographicHeight", named.camera.orthographicHeight);
    fields.read("pivotDistance", named.camera.pivotDistance);
    named.camera.projection = isOrthographic ? Projection::Orthographic : Projection::Perspective;
    if (named.camera.fovYRadians <= 0.01F || named.camera.fovYRadians >= 3.1F) {
        fields.complain("fovY", "must lie between 0.01 and 3.1 radians");
    }
    if (named.camera.orthographicHeight <= 0.0F || named.camera.pivotDistance <= 0.0F) {
        fields.complain("", "must have heights and distances above zero");
    }
    named.unknownMembers = fields.unknown();
}

Lighting readLighting(JsonFields fields)
{
    Lighting light;
    fields.read("sunAzimuth", light.sunAzimuthRadians);
    fields.read("sunElevation", light.sunElevationRadians);
    fields.read("sunColor", light.sunColor);
    fields.read("sunStrength", light.sunStrength);
    fields.read("ambientColor", light.ambientColor);
    fields.read("ambientStrength", light.ambientStrength);
    fields.read("skyZenith", light.skyZenith);
    fields.read("skyHorizon", light.skyHorizon);
    fields.read("ground", light.ground);
    fields.read("groundGrid", light.showGroundGrid);
    light.unknownMembers = fields.unknown();
    return light;
}

template<class Item>
std::vector<Item> readList(JsonFields& top, const char* key, std::string& problem)
{
    std::vector<Item> items;
    const json* list = top.find(key);
    if (list == nullptr) {
        return items;
    }
    if (!list->is_array()) {
        top.complain(key, "must be a list");
        return items;
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
        const std::string place = std::string(key) + "[" + std::to_string(i) + "]";
        readItem(JsonFields((*list)[i], place, problem), items.emplace_back(), place, problem);
    }
    return items;
}

/// Entries ascend by id, which is neither 0 nor given twice.
template<class Entry>
void sortById(std::vector<Entry>& entries, const char* key, std::string& problem)
{
    std::ranges::sort(entries, {}, &Entry::id);
    for (std::size_t i = 0; i < entries.size() && problem.empty(); ++i) {
        if (entries[i].id == 0 || (i > 0 && entries[i].id == entries[i - 1].id)) {
            problem = std::string(key) + ": the id " + std::to_string(entries[i].id) +
                      (entries[i].id == 0 ? " is not allowed" : " is given twice");
        }
    }
}

} // namespace

Result<void> checkFormat(const json& top)
{
    if (!top.is_object() || top.value("format", json()) != kProjectFormat) {
        return Error{"This is not a Crowdbrush scene (there is no \"format\": \"" +
                     std::string(kProjectFormat) +
                     "\"). Models are brought in with Import, not opened."};
    }
    const json version = top.value("version", json());
    if (!version.is_number_unsigned() || version == 0U) {
        return Error{"Its \"version\" must be a whole number above zero; restore an older copy."};
    }
    if (version > kProjectVersion) {
        return Error{"It was written by a newer Crowdbrush (file version " + version.dump() +
                     ", this program reads up to " + std::to_string(kProjectVersion) +
                     "). Update Crowdbrush to open it."};
    }
    return {};
}

json headerToJson(const Scene& scene)
{
    json top = withUnknown(scene.unknownMembers, json::object());
    top["format"] = kProjectFormat;
    top["version"] = kProjectVersion;
    top["name"] = scene.name;
    top["seed"] = scene.seed;
    top["nextId"] = scene.nextId;
    top["templates"] = listToJson(scene.templates);
    top["stages"] = listToJson(scene.stages);
    top["cameras"] = listToJson(scene.cameras);
    top["lighting"] = toJson(scene.lighting);
    writeEnvironment(scene, top);
    writeRules(scene, top);
    return top;
}

Result<Scene> headerFromJson(const json& top)
{
    Scene scene;
    std::string problem;
    JsonFields fields(top, "", problem);
    fields.read("name", scene.name);
    fields.read("seed", scene.seed);
    fields.read("nextId", scene.nextId);
    if (scene.nextId == 0 || scene.nextId > kMaxIndividualId) {
        fields.complain("nextId", "must be above zero and at most 4000000000");
    }
    scene.templates = readList<TemplateEntry>(fields, "templates", problem);
    scene.stages = readList<StageEntry>(fields, "stages", problem);
    scene.cameras = readList<NamedCamera>(fields, "cameras", problem);
    if (const json* lighting = fields.find("lighting")) {
        scene.lighting = readLighting(JsonFields(*lighting, "lighting", problem));
    }
    readEnvironment(fields, scene, problem);
    readRules(fields, scene, problem);
    if (const json* table = fields.find("individuals")) {
        JsonFields tableFields(*table, "individuals", problem);
        (void)tableFields.find("columns");
        scene.unknownTableMembers = tableFields.unknown();
    }
    sortById(scene.templates, "templates", problem);
    sortById(scene.stages, "stages", problem);
    if (!problem.empty()) {
        return Error{problem};
    }
    for (const char* known : {"format", "version"}) {
        (void)fields.find(known);
    }
    scene.unknownMembers = fields.unknown();
    return scene;
}

} // namespace crowd::model
