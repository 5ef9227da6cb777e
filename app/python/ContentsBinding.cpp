// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "app/python/Binding.h"
#include "model/project/EnvironmentText.h"

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

float aboveZero(float value, const char* name)
{
    if (!(value > 0.0F) || !std::isfinite(value)) {
        throw ScriptError(std::string(name) + " must be a finite number above zero.");
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
        entry.import.scale = aboveZero(*scale, "scale");
    }
    if (rotation) {
        const auto& [w, x, y, z] = *rotation;
        entry.import.rotation = {finite(w, "rotation"), finite(x, "rotation"),
                                 finite(y, "rotation"), finite(z, "rotation")};
    }
    if (groundOffset) {
        entry.import.groundOffset = finite(*groundOffset, "ground_offset");
    }
    entry.import.removeRootMotion = removeRootMotion.value_or(entry.import.removeRootMotion);
    if (clipSpeeds) {
        entry.clipSpeeds.clear();
        for (const Maybe<float>& each : *clipSpeeds) {
            entry.clipSpeeds.push_back(each ? finite(*each, "clip_speeds")
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

TemplateId idOf(const py::object& given)
{
    return py::isinstance<TemplateHandle>(given) ? given.cast<const TemplateHandle&>().id
                                                 : given.cast<TemplateId>();
}

TemplateHandle addTemplate(const ScenePtr& scene, const FilePath& path, const std::string& name,
                           TemplateId id, const Maybe<float>& scale,
                           const Maybe<Rotation>& rotation, const Maybe<float>& groundOffset,
                           const Maybe<bool>& removeRootMotion, const Maybe<Speeds>& clipSpeeds,
                           const Maybe<Roles>& clipRoles)
{
    TemplateEntry entry;
    entry.id = id;
    entry.path = path.string();
    entry.name = name;
    ImportArguments{scale, rotation, groundOffset, removeRootMotion, clipSpeeds, clipRoles}.applyTo(
        entry);
    return {scene, valueOrRaise(scene->addTemplate(entry))};
}

void changeTemplate(const ScenePtr& scene, const py::object& which, const Maybe<FilePath>& path,
                    const Maybe<std::string>& name, const Maybe<float>& scale,
                    const Maybe<Rotation>& rotation, const Maybe<float>& groundOffset,
                    const Maybe<bool>& removeRootMotion, const Maybe<Speeds>& clipSpeeds,
                    const Maybe<Roles>& clipRoles)
{
    TemplateEntry entry = TemplateHandle{scene, idOf(which)}.entry();
    entry.path = path ? path->string() : entry.path;
    entry.name = name.value_or(entry.name);
    ImportArguments{scale, rotation, groundOffset, removeRootMotion, clipSpeeds, clipRoles}.applyTo(
        entry);
    valueOrRaise(scene->changeTemplate(entry));
}

StageEntry stageOf(const ScenePtr& scene, std::uint8_t id)
{
    const auto now = scene->scene();
    const StageEntry* entry = now->findStage(id);
    if (entry == nullptr) {
        throw ScriptError("The scene has no stage " + std::to_string(id) +
                          ": take one of scene.stages.");
    }
    return *entry;
}

std::uint8_t stageId(const py::object& given)
{
    return py::isinstance<StageEntry>(given) ? given.cast<const StageEntry&>().id
                                             : given.cast<std::uint8_t>();
}

StageEntry addStage(const ScenePtr& scene, const FilePath& path, const std::string& name,
                    const Point3& position, float heading, float scale, std::uint8_t id)
{
    StageEntry entry;
    entry.id = id;
    entry.path = path.string();
    entry.name = name;
    entry.position = toVector(position, "position");
    entry.headingRadians = finite(heading, "heading");
    entry.scale = aboveZero(scale, "scale");
    return stageOf(scene, valueOrRaise(scene->addStage(entry)));
}

void changeStage(const ScenePtr& scene, const py::object& which, const Maybe<FilePath>& path,
                 const Maybe<std::string>& name, const Maybe<Point3>& position,
                 const Maybe<float>& heading, const Maybe<float>& scale)
{
    StageEntry entry = stageOf(scene, stageId(which));
    entry.path = path ? path->string() : entry.path;
    entry.name = name.value_or(entry.name);
    if (position) {
        entry.position = toVector(*position, "position");
    }
    if (heading) {
        entry.headingRadians = finite(*heading, "heading");
    }
    if (scale) {
        entry.scale = aboveZero(*scale, "scale");
    }
    valueOrRaise(scene->changeStage(entry));
}

py::dict cameras(const ScenePtr& scene)
{
    py::dict all;
    const auto now = scene->scene();
    for (const NamedCamera& each : now->cameras) {
        all[py::str(each.name)] = each.camera;
    }
    return all;
}

void setCameras(const ScenePtr& scene, const std::vector<std::pair<std::string, Camera>>& named)
{
    std::vector<NamedCamera> all;
    for (const auto& [name, camera] : named) {
        all.push_back({name, camera});
    }
    valueOrRaise(scene->setCameras(std::move(all)));
}

Point3 toPoint(const glm::vec3& vector)
{
    return {vector.x, vector.y, vector.z};
}

auto colorGetter(glm::vec3 Lighting::*member)
{
    return [member](const Lighting& light) { return toPoint(light.*member); };
}

Lighting makeLighting(float sunAzimuth, float sunElevation, const Point3& sunColor,
                      float sunStrength, const Point3& ambientColor, float ambientStrength,
                      const Point3& skyZenith, const Point3& skyHorizon, const Point3& ground,
                      bool groundGrid)
{
    Lighting light;
    light.sunAzimuthRadians = finite(sunAzimuth, "sun_azimuth");
    light.sunElevationRadians = finite(sunElevation, "sun_elevation");
    light.sunColor = toVector(sunColor, "sun_color");
    light.sunStrength = finite(sunStrength, "sun_strength");
    light.ambientColor = toVector(ambientColor, "ambient_color");
    light.ambientStrength = finite(ambientStrength, "ambient_strength");
    light.skyZenith = toVector(skyZenith, "sky_zenith");
    light.skyHorizon = toVector(skyHorizon, "sky_horizon");
    light.ground = toVector(ground, "ground");
    light.showGroundGrid = groundGrid;
    return light;
}

void bindLighting(py::module_& module)
{
    const Lighting usual;
    py::class_<Lighting>(module, "Lighting",
                         "Sun, sky and ground. Angles in radians, colours sRGB 0–1.")
        .def(py::init(&makeLighting), py::kw_only(),
             py::arg("sun_azimuth") = usual.sunAzimuthRadians,
             py::arg("sun_elevation") = usual.sunElevationRadians,
             py::arg("sun_color") = toPoint(usual.sunColor),
             py::arg("sun_strength") = usual.sunStrength,
             py::arg("ambient_color") = toPoint(usual.ambientColor),
             py::arg("ambient_strength") = usual.ambientStrength,
             py::arg("sky_zenith") = toPoint(usual.skyZenith),
             py::arg("sky_horizon") = toPoint(usual.skyHorizon),
             py::arg("ground") = toPoint(usual.ground),
             py::arg("ground_grid") = usual.showGroundGrid)
        .def_readonly("sun_azimuth", &Lighting::sunAzimuthRadians, "From +Z towards +X.")
        .def_readonly("sun_elevation", &Lighting::sunElevationRadians)
        .def_property_readonly("sun_color", colorGetter(&Lighting::sunColor))
        .def_readonly("sun_strength", &Lighting::sunStrength)
        .def_property_readonly("ambient_color", colorGetter(&Lighting::ambientColor))
        .def_readonly("ambient_strength", &Lighting::ambientStrength)
        .def_property_readonly("sky_zenith", colorGetter(&Lighting::skyZenith))
        .def_property_readonly("sky_horizon", colorGetter(&Lighting::skyHorizon))
        .def_property_readonly("ground", colorGetter(&Lighting::ground))
        .def_readonly("ground_grid", &Lighting::showGroundGrid);
}

void bindStage(py::module_& module)
{
    py::class_<StageEntry>(module, "Stage", "A stage as it is placed in a scene, for reading.")
        .def_readonly("id", &StageEntry::id)
        .def_readonly("name", &StageEntry::name)
        .def_readonly("path", &StageEntry::path)
        .def_property_readonly(
            "position", [](const StageEntry& stage) { return toPoint(stage.position); },
            "World frame, metres.")
        .def_readonly("heading", &StageEntry::headingRadians, "Radians.")
        .def_readonly("scale", &StageEntry::scale)
        .def("__repr__", [](const StageEntry& stage) { return "<Stage " + stage.name + ">"; });
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
        .def("add_template", &addTemplate, py::arg("path"), py::arg("name") = "", py::kw_only(),
             py::arg("id") = 0, py::arg("scale") = py::none(), py::arg("rotation") = py::none(),
             py::arg("ground_offset") = py::none(), py::arg("remove_root_motion") = py::none(),
             py::arg("clip_speeds") = py::none(), py::arg("clip_roles") = py::none(),
             "A .glb or .gltf file, or a built-in one such as builtin:templates/man.glb. The rest "
             "is what the import dialog asks for: a scale, a rotation (w, x, y, z), metres added "
             "to Y, and clip by clip ground speeds in m/s (None: the file's) and roles, which say "
             "what people stand, walk and sit with: \"idle\", \"walk\", \"run\", \"fly\", "
             "\"sit\" or \"other\" (None: the proposed one).")
        .def("change_template", &changeTemplate, py::arg("template"), py::kw_only(),
             py::arg("path") = py::none(), py::arg("name") = py::none(),
             py::arg("scale") = py::none(), py::arg("rotation") = py::none(),
             py::arg("ground_offset") = py::none(), py::arg("remove_root_motion") = py::none(),
             py::arg("clip_speeds") = py::none(), py::arg("clip_roles") = py::none(),
             "By handle or id; what is not given stays. See add_template.")
        .def(
            "remove_template",
            [](const ScenePtr& s, const py::object& which) {
                valueOrRaise(s->removeTemplate(idOf(which)));
            },
            py::arg("template"), "By handle or id; refused as long as somebody is of it.");
}

void bindStageCalls(SceneClass& scene)
{
    scene
        .def_property_readonly(
            "stages", [](const ScenePtr& s) { return s->scene()->stages; },
            "Geometry that people stand on, as it is placed.")
        .def("add_stage", &addStage, py::arg("path"), py::arg("name") = "",
             py::arg("position") = Point3{0, 0, 0}, py::arg("heading") = 0.0F,
             py::arg("scale") = 1.0F, py::kw_only(), py::arg("id") = 0,
             "A .glb or .gltf file, or a built-in one such as builtin:stages/theatre.glb. Metres, "
             "radians.")
        .def("change_stage", &changeStage, py::arg("stage"), py::kw_only(),
             py::arg("path") = py::none(), py::arg("name") = py::none(),
             py::arg("position") = py::none(), py::arg("heading") = py::none(),
             py::arg("scale") = py::none(), "By stage or id; what is not given stays.")
        .def(
            "remove_stage",
            [](const ScenePtr& s, const py::object& which) {
                valueOrRaise(s->removeStage(stageId(which)));
            },
            py::arg("stage"), "By stage or id.");
}

void bindCameraCalls(SceneClass& scene)
{
    scene.def_property_readonly("cameras", &cameras, "Name → Camera.")
        .def(
            "set_camera",
            [](const ScenePtr& s, const std::string& name, const Camera& camera) {
                valueOrRaise(s->setCamera(name, camera));
            },
            py::arg("name"), py::arg("camera"), "Moves the one of that name, or adds it.")
        .def(
            "remove_camera",
            [](const ScenePtr& s, const std::string& name) { valueOrRaise(s->removeCamera(name)); },
            py::arg("name"), "Raises Error where there is none of that name.")
        .def("set_cameras", &setCameras, py::arg("cameras"),
             "All of them, as pairs of name and Camera, in this order.")
        .def_property_readonly(
            "lighting", [](const ScenePtr& s) { return s->scene()->lighting; },
            "As it is now; changed with set_lighting.")
        .def(
            "set_lighting",
            [](const ScenePtr& s, const Lighting& light) { valueOrRaise(s->setLighting(light)); },
            py::arg("lighting"), "Sun, sky and ground as given.");
}

py::object environment(const ScenePtr& scene)
{
    return py::module_::import("json").attr("loads")(environmentText(*scene->scene()));
}

/// Raises where a number has no finite value, naming its place: JSON has no words for those.
void refuseInfinite(const py::handle& value, const std::string& place)
{
    if (py::isinstance<py::float_>(value) && !std::isfinite(value.cast<double>())) {
        throw ScriptError(place + " must be a finite number.");
    }
    if (py::isinstance<py::dict>(value)) {
        for (const auto& [key, item] : value.cast<py::dict>()) {
            refuseInfinite(item, place + "." + py::str(key).cast<std::string>());
        }
    } else if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
        std::size_t index = 0;
        for (const py::handle item : value) {
            refuseInfinite(item, place + "[" + std::to_string(index++) + "]");
        }
    }
}

void setEnvironment(const ScenePtr& scene, const py::object& given)
{
    refuseInfinite(given, "environment");
    const py::object text =
        py::isinstance<py::str>(given) ? given : py::module_::import("json").attr("dumps")(given);
    valueOrRaise(scene->setEnvironment(text.cast<std::string>()));
}

void bindEnvironment(SceneClass& scene)
{
    scene
        .def_property_readonly(
            "environment", &environment,
            "A dict of lists as the project file has them: places, paths, tags, rules, "
            "numbers, cues, the surface to walk on, and stepsPerSecond.")
        .def("set_environment", &setEnvironment, py::arg("environment"),
             "Lists of places, paths, tags, rules and so on as in environment, or the same as JSON "
             "text; "
             "what is not in it stays. Raises Error where a member is wrong.");
}

} // namespace

void bindContents(py::module_& module, SceneClass& scene)
{
    bindLighting(module);
    bindStage(module);
    bindTemplateCalls(scene);
    bindStageCalls(scene);
    bindCameraCalls(scene);
    bindEnvironment(scene);
}

} // namespace crowd::app
