// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "app/python/Binding.h"
#include "app/python/FieldBinding.h"
#include "app/python/ScriptAssets.h"
#include "app/python/ScriptEnvironment.h"
#include "model/describe/FieldChecks.h"
#include "model/scene/DayLight.h"
#include "model/scene/ReadyLight.h"

namespace crowd::app {

using namespace model;

namespace {

template<class T>
using Maybe = std::optional<T>;
using Speeds = std::vector<Maybe<float>>;
using Roles = std::vector<Maybe<std::string>>;
using Rotation = std::array<float, 4>;

std::vector<TemplateHandle> templates(const ScenePtr& scene)
{
    std::vector<TemplateHandle> handles;
    const auto now = scene->scene();
    for (const TemplateEntry& entry : now->templates) {
        handles.push_back({scene, entry.id});
    }
    return handles;
}

float finite(float value, const char* name)
{
    if (!std::isfinite(value)) {
        throw ScriptError(std::string(name) + " must be a finite number.");
    }
    return value;
}

std::string text(float value)
{
    return py::str(py::float_(static_cast<double>(value)));
}

float within(float value, const char* name, float low, float high)
{
    if (!(value >= low && value <= high)) { // also where it is not a number
        throw ScriptError(std::string(name) + " is " + text(value) + "; it must lie from " +
                          text(low) + " to " + text(high) + ".");
    }
    return value;
}

ClipRole roleNamed(const std::string& key)
{
    const std::optional<ClipRole> role = clipRoleOf(key);
    if (!role) {
        std::string known;
        for (const ClipRoleInfo& info : clipRoles()) {
            known += (known.empty() ? "\"" : ", \"") + std::string(info.key) + "\"";
        }
        throw ScriptError("clip_roles: there is no role \"" + key + "\". Choose one of " + known +
                          ", or None for the proposed one.");
    }
    return *role;
}

/// What the import dialog asks for, each left as it is where nothing is given.
struct ImportArguments
{
    Maybe<float> scale;
    Maybe<Rotation> rotation;
    Maybe<float> groundOffset;
    Maybe<bool> removeRootMotion;
    Maybe<Speeds> clipSpeeds;
    Maybe<Roles> clipRoles;

    void applyTo(TemplateEntry& entry) const;
};

void ImportArguments::applyTo(TemplateEntry& entry) const
{
    if (scale) {
        entry.import.scale = *scale;
    }
    if (rotation) {
        const auto& [w, x, y, z] = *rotation;
        entry.import.rotation = {finite(w, "rotation"), finite(x, "rotation"),
                                 finite(y, "rotation"), finite(z, "rotation")};
    }
    if (groundOffset) {
        entry.import.groundOffset = *groundOffset;
    }
    entry.import.removeRootMotion = removeRootMotion.value_or(entry.import.removeRootMotion);
    needLegal(fieldsOf<ImportSettings>(), &entry.import);
    if (clipSpeeds) {
        entry.clipSpeeds.clear();
        for (const Maybe<float>& each : *clipSpeeds) {
            entry.clipSpeeds.push_back(each ? within(*each, "clip_speeds", -100.0F, 100.0F)
                                            : std::numeric_limits<float>::quiet_NaN());
        }
    }
    if (clipRoles) {
        entry.clipRoles.clear();
        for (const Maybe<std::string>& each : *clipRoles) {
            entry.clipRoles.push_back(each ? Maybe<ClipRole>(roleNamed(*each)) : std::nullopt);
        }
    }
}

TemplateHandle addTemplateGiven(const ScenePtr& scene, const FilePath& path,
                                const std::string& name, TemplateId id, const Maybe<float>& scale,
                                const Maybe<Rotation>& rotation, const Maybe<float>& groundOffset,
                                const Maybe<bool>& removeRootMotion,
                                const Maybe<Speeds>& clipSpeeds, const Maybe<Roles>& clipRoles)
{
    TemplateEntry entry;
    entry.id = id;
    entry.path = path.string();
    entry.name = name;
    ImportArguments{scale, rotation, groundOffset, removeRootMotion, clipSpeeds, clipRoles}.applyTo(
        entry);
    const TemplateId added = valueOrRaise(addTemplate(*scene, entry));
    scene->noteBirth(added);
    return {scene, added};
}

void changeTemplateGiven(const ScenePtr& scene, const py::object& which,
                         const Maybe<FilePath>& path, const Maybe<std::string>& name,
                         const Maybe<float>& scale, const Maybe<Rotation>& rotation,
                         const Maybe<float>& groundOffset, const Maybe<bool>& removeRootMotion,
                         const Maybe<Speeds>& clipSpeeds, const Maybe<Roles>& clipRoles)
{
    TemplateEntry entry = TemplateHandle{scene, templateIdOf(scene, which)}.entry();
    entry.path = path ? path->string() : entry.path;
    entry.name = name.value_or(entry.name);
    ImportArguments{scale, rotation, groundOffset, removeRootMotion, clipSpeeds, clipRoles}.applyTo(
        entry);
    valueOrRaise(changeTemplate(*scene, entry));
}

StageHandle stageOf(const ScenePtr& scene, std::uint8_t id)
{
    const auto now = scene->scene();
    const StageEntry* entry = now->findStage(id);
    if (entry == nullptr) {
        throw ScriptError("The scene has no stage " + std::to_string(id) +
                          ": take one of scene.stages.");
    }
    return {scene, *entry};
}

std::vector<StageHandle> stages(const ScenePtr& scene)
{
    std::vector<StageHandle> handles;
    const auto now = scene->scene();
    for (const StageEntry& entry : now->stages) {
        handles.push_back({scene, entry});
    }
    return handles;
}

std::uint8_t stageId(const ScenePtr& scene, const py::object& given)
{
    if (py::isinstance<StageHandle>(given)) {
        const auto& handle = given.cast<const StageHandle&>();
        if (handle.owner != scene) {
            throw ScriptError("Stage " + handle.entry.name +
                              " belongs to another scene: take one of this scene's stages, or add "
                              "it here with add_stage.");
        }
        return handle.entry.id;
    }
    constexpr long kHighest = 255;
    const bool isNumber = py::isinstance<py::int_>(given) && !py::isinstance<py::bool_>(given);
    const long id = isNumber ? PyLong_AsLong(given.ptr()) : -1;
    PyErr_Clear(); // of numbers without end
    if (id < 0 || id > kHighest) {
        throw ScriptError("A stage is one of scene.stages or its id, not " + shortly(given) + ".");
    }
    return static_cast<std::uint8_t>(id);
}

StageHandle addStageGiven(const ScenePtr& scene, const FilePath& path, const std::string& name,
                          const Point3& position, float heading, float scale, std::uint8_t id)
{
    StageEntry entry;
    entry.id = id;
    entry.path = path.string();
    entry.name = name;
    entry.position = {position[0], position[1], position[2]};
    entry.headingRadians = heading;
    entry.scale = scale;
    needLegal(fieldsOf<StageEntry>(), &entry);
    return stageOf(scene, valueOrRaise(addStage(*scene, entry)));
}

void changeStageGiven(const ScenePtr& scene, const py::object& which, const Maybe<FilePath>& path,
                      const Maybe<std::string>& name, const Maybe<Point3>& position,
                      const Maybe<float>& heading, const Maybe<float>& scale)
{
    StageEntry entry = stageOf(scene, stageId(scene, which)).entry;
    entry.path = path ? path->string() : entry.path;
    entry.name = name.value_or(entry.name);
    if (position) {
        entry.position = {(*position)[0], (*position)[1], (*position)[2]};
    }
    entry.headingRadians = heading.value_or(entry.headingRadians);
    entry.scale = scale.value_or(entry.scale);
    needLegal(fieldsOf<StageEntry>(), &entry);
    valueOrRaise(changeStage(*scene, entry));
}

py::dict cameras(const ScenePtr& scene)
{
    py::dict all;
    const std::vector<NamedCamera> known = scene->scene()->cameras;
    for (const NamedCamera& each : known) {
        all[py::str(each.name)] = each.camera;
    }
    return all;
}

void needCameraName(const std::string& name)
{
    if (name.find_first_not_of(" \t\r\n") == std::string::npos) {
        throw ScriptError("A camera needs a name.");
    }
}

py::dict lookOfCameras(const ScenePtr& scene)
{
    py::dict all;
    const auto now = scene->scene();
    for (const NamedCamera& each : now->cameras) {
        const LookPreset* look = findLook(now->looks, each.look);
        all[py::str(each.name)] = look != nullptr ? look->name : std::string();
    }
    return all;
}

void setCamerasGiven(const ScenePtr& scene,
                     const std::vector<std::pair<std::string, Camera>>& named,
                     const std::map<std::string, std::string>& looks)
{
    std::vector<NamedCamera> all;
    std::set<std::string> names;
    for (const auto& [name, camera] : named) {
        needCameraName(name);
        if (!names.insert(name).second) {
            throw ScriptError("Two cameras are named \"" + name +
                              "\": give each a name of its own.");
        }
        const auto look = looks.find(name);
        const std::string lookName = look != looks.end() ? look->second : std::string();
        all.push_back({name, camera, valueOrRaise(lookNamed(*scene->scene(), lookName))});
    }
    for (const auto& [name, look] : looks) {
        if (!names.contains(name)) {
            throw ScriptError("looks names \"" + name + "\", which is no camera of these.");
        }
    }
    valueOrRaise(setCameras(*scene, std::move(all)));
}

Point3 toPoint(const glm::vec3& vector)
{
    return {vector.x, vector.y, vector.z};
}

std::string readyLightKeys()
{
    std::string all;
    for (const ReadyLight& each : readyLights()) {
        all += (all.empty() ? "" : ", ") + std::string(each.key);
    }
    return all;
}

void bindLighting(py::module_& module)
{
    bindNamed<Lighting>(module, "Lighting",
                        "Sun, sky and ground. Angles in radians, colours sRGB 0–1.",
                        fieldsOf<Lighting>())
        .def_static(
            "ready",
            [](const std::string& key) {
                const ReadyLight* found = findReadyLight(key);
                if (found == nullptr) {
                    throw ScriptError("There is no ready-made light \"" + key + "\"; there are " +
                                      readyLightKeys() + ".");
                }
                return found->light;
            },
            py::arg("key"),
            "A ready-made one: \"noon\", \"afternoon\", \"dusk\", \"overcast\", \"night\" or "
            "\"studio\".")
        .def_static(
            "of_day",
            [](float hours, float haze) {
                if (!std::isfinite(hours)) {
                    throw ScriptError("hours must be a finite number.");
                }
                if (!(haze >= 0.0F && haze <= 0.999F)) {
                    throw ScriptError("haze must lie between 0 and 0.999.");
                }
                Lighting light = newLighting();
                light.haze = haze;
                setDayHours(light, hours);
                return light;
            },
            py::arg("hours"), py::arg("haze") = 0.0F,
            "Sun or moon and sky as they are at an hour of 0–24, paler and softer the more haze "
            "there is.");
}

void bindStage(py::module_& module)
{
    const auto reader = [](auto StageEntry::*member) {
        return [member](const StageHandle& stage) { return stage.entry.*member; };
    };
    py::class_<StageHandle>(module, "Stage", "A stage as it is placed in a scene, for reading.")
        .def_property_readonly("id", reader(&StageEntry::id))
        .def_property_readonly("name", reader(&StageEntry::name))
        .def_property_readonly("path", reader(&StageEntry::path))
        .def_property_readonly(
            "position", [](const StageHandle& stage) { return toPoint(stage.entry.position); },
            "World frame, metres.")
        .def_property_readonly("heading", reader(&StageEntry::headingRadians), "Radians.")
        .def_property_readonly("scale", reader(&StageEntry::scale))
        .def("__repr__",
             [](const StageHandle& stage) { return "<Stage " + stage.entry.name + ">"; });
}

void bindTemplateCalls(SceneClass& scene)
{
    scene.def_property_readonly("templates", &templates, "Characters to make copies of.")
        .def(
            "template",
            [](const ScenePtr& s, const std::string& name) {
                for (const TemplateHandle& each : templates(s)) {
                    if (each.entry().name == name) {
                        return each;
                    }
                }
                throw ScriptError("The scene has no template named \"" + name + "\".");
            },
            py::arg("name"), "The first one of that name.")
        .def("add_template", &addTemplateGiven, py::arg("path"), py::arg("name") = "",
             py::kw_only(), py::arg("id") = 0, py::arg("scale") = py::none(),
             py::arg("rotation") = py::none(), py::arg("ground_offset") = py::none(),
             py::arg("remove_root_motion") = py::none(), py::arg("clip_speeds") = py::none(),
             py::arg("clip_roles") = py::none(),
             "A .glb or .gltf file, or a built-in one such as builtin:templates/man.glb. The rest "
             "is what the import dialog asks for: a scale, a rotation (w, x, y, z), metres added "
             "to Y, and clip by clip ground speeds in m/s (None: the file's) and roles, which say "
             "what people stand, walk and sit with: \"idle\", \"walk\", \"run\", \"fly\", "
             "\"sit\" or \"other\" (None: the proposed one).")
        .def("change_template", &changeTemplateGiven, py::arg("template"), py::kw_only(),
             py::arg("path") = py::none(), py::arg("name") = py::none(),
             py::arg("scale") = py::none(), py::arg("rotation") = py::none(),
             py::arg("ground_offset") = py::none(), py::arg("remove_root_motion") = py::none(),
             py::arg("clip_speeds") = py::none(), py::arg("clip_roles") = py::none(),
             "By handle or id; what is not given stays. See add_template.")
        .def(
            "remove_template",
            [](const ScenePtr& s, const py::object& which) {
                valueOrRaise(removeTemplate(*s, templateIdOf(s, which)));
            },
            py::arg("template"), "By handle or id; refused as long as somebody is of it.");
}

void bindStageCalls(SceneClass& scene)
{
    scene
        .def_property_readonly("stages", &stages, "Geometry that people stand on, as it is placed.")
        .def("add_stage", &addStageGiven, py::arg("path"), py::arg("name") = "",
             py::arg("position") = Point3{0, 0, 0}, py::arg("heading") = 0.0F,
             py::arg("scale") = 1.0F, py::kw_only(), py::arg("id") = 0,
             "A .glb or .gltf file, or a built-in one such as builtin:stages/theatre.glb. Metres, "
             "radians.")
        .def("change_stage", &changeStageGiven, py::arg("stage"), py::kw_only(),
             py::arg("path") = py::none(), py::arg("name") = py::none(),
             py::arg("position") = py::none(), py::arg("heading") = py::none(),
             py::arg("scale") = py::none(), "By stage or id; what is not given stays.")
        .def(
            "remove_stage",
            [](const ScenePtr& s, const py::object& which) {
                valueOrRaise(removeStage(*s, stageId(s, which)));
            },
            py::arg("stage"), "By stage or id.");
}

void bindCameraCalls(SceneClass& scene)
{
    scene.def_property_readonly("cameras", &cameras, "Name → Camera.")
        .def(
            "set_camera",
            [](const ScenePtr& s, const std::string& name, const Camera& camera,
               const std::optional<std::string>& look) {
                needCameraName(name);
                valueOrRaise(setCamera(*s, name, camera, look));
            },
            py::arg("name"), py::arg("camera"), py::arg("look") = py::none(),
            "Moves the one of that name, or adds it. look: the name of one of the scene's, which "
            "the view takes on with this camera; \"\": none; None: as it was.")
        .def(
            "remove_camera",
            [](const ScenePtr& s, const std::string& name) {
                valueOrRaise(removeCamera(*s, name));
            },
            py::arg("name"), "Raises Error where there is none of that name.")
        .def("set_cameras", &setCamerasGiven, py::arg("cameras"),
             py::arg("looks") = std::map<std::string, std::string>(),
             "All of them, as pairs of name and Camera, in this order. looks: name of the camera → "
             "name of its look, of those that have one.")
        .def_property_readonly("camera_looks", &lookOfCameras,
                               "Name of the camera → name of its look, empty where it has none.")
        .def_property_readonly(
            "lighting", [](const ScenePtr& s) { return s->scene()->lighting; },
            "A copy of how it is now; changed with set_lighting.")
        .def(
            "set_lighting",
            [](const ScenePtr& s, const Lighting& light) {
                needLegal(fieldsOf<Lighting>(), &light);
                valueOrRaise(setLighting(*s, light));
            },
            py::arg("lighting"), "Sun, sky and ground as given.");
}

} // namespace

void bindContents(py::module_& module, SceneClass& scene)
{
    bindLighting(module);
    bindStage(module);
    bindTemplateCalls(scene);
    bindStageCalls(scene);
    bindCameraCalls(scene);
}

} // namespace crowd::app
