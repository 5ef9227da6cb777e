// SPDX-License-Identifier: MIT
#include "model/project/ProjectHeader.h"

#include <nlohmann/json.hpp>

#include "model/project/JsonFields.h"
#include "model/project/JsonWriting.h"
#include "model/project/MemberJson.h"

namespace crowd::model {

using nlohmann::json;

Result<void> checkFormat(const json& top)
{
    if (!top.is_object() || top.value("format", json()) != kProjectFormat) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "This is not a Crowdbrush scene (there is no \"format\": "
                                       "\"%1\"). Models are brought in with Import, not opened."),
                     kProjectFormat};
    }
    const json version = top.value("version", json());
    if (!version.is_number_unsigned() || version == 0U) {
        return Error{QT_TRANSLATE_NOOP(
            "Messages",
            "Its \"version\" must be a whole number above zero; restore an older copy.")};
    }
    if (version > kProjectVersion) {
        return Error{QT_TRANSLATE_NOOP(
                         "Messages", "It was written by a newer Crowdbrush (file version %1, this "
                                     "program reads up to %2). Update Crowdbrush to open it."),
                     version.dump(), kProjectVersion};
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
    writeMembers(scene, top);
    return top;
}

Result<Scene> headerFromJson(const json& top)
{
    Scene scene;
    Message problem;
    JsonFields fields(top, "", problem);
    fields.read("name", scene.name);
    fields.read("seed", scene.seed);
    fields.read("nextId", scene.nextId);
    if (scene.nextId == 0 || scene.nextId > kMaxIndividualId) {
        fields.complain("nextId", QT_TRANSLATE_NOOP(
                                      "Messages", "%1 must be above zero and at most 4000000000"));
    }
    readMembers(fields, scene, problem);
    if (const json* table = fields.find("individuals")) {
        JsonFields tableFields(*table, "individuals", problem);
        (void)tableFields.find("columns");
        scene.unknownTableMembers = tableFields.unknown();
    }
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
