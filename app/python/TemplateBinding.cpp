// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "app/python/Binding.h"
#include "model/bake/ClipBaker.h"
#include "model/brush/ClipChoice.h"

namespace crowd::app {

using namespace model;

TemplateEntry TemplateHandle::entry() const
{
    const auto scene = owner->scene();
    const TemplateEntry* found = scene->findTemplate(id);
    if (found == nullptr || owner->birthOf(id) != birth) {
        throw ScriptError("The template with id " + std::to_string(id) +
                          " is no longer in the scene.");
    }
    return *found;
}

TemplatePtr TemplateHandle::asset() const
{
    const TemplateEntry known = entry();
    if (!known.asset) {
        throw ScriptError("Template " + known.name + " is not loaded. " + known.problem.english());
    }
    return known.asset;
}

std::string shortly(const py::handle& given)
{
    constexpr std::size_t kLongest = 60;
    const auto text = py::reinterpret_steal<py::object>(PyObject_ASCII(given.ptr()));
    if (!text) {
        PyErr_Clear(); // an object that cannot even say what it is
        return std::string("an object of type ") + Py_TYPE(given.ptr())->tp_name;
    }
    const auto whole = text.cast<std::string>();
    return whole.size() <= kLongest ? whole : whole.substr(0, kLongest) + "...";
}

TemplateId templateIdOf(const ScenePtr& scene, const py::handle& given)
{
    if (py::isinstance<TemplateHandle>(given)) {
        const auto& handle = given.cast<const TemplateHandle&>();
        if (handle.owner != scene) {
            throw ScriptError("Template " + handle.entry().name +
                              " belongs to another scene: take one of this scene's templates, or "
                              "add it here with add_template.");
        }
        if (scene && scene->birthOf(handle.id) != handle.birth) {
            (void)handle.entry(); // says that it is gone
        }
        return handle.id;
    }
    const bool isNumber = PyIndex_Check(given.ptr()) != 0 && !py::isinstance<py::bool_>(given);
    const auto number =
        py::reinterpret_steal<py::object>(isNumber ? PyNumber_Index(given.ptr()) : nullptr);
    const long id = number ? PyLong_AsLong(number.ptr()) : -1;
    PyErr_Clear(); // arrays, and numbers without end
    if (id < 0 || id > static_cast<long>(std::numeric_limits<TemplateId>::max())) {
        throw ScriptError("A template is one of scene.templates or its id, not " + shortly(given) +
                          ".");
    }
    return static_cast<TemplateId>(id);
}

namespace {

std::vector<ClipInfo> clipsOf(const TemplateHandle& handle)
{
    std::vector<ClipInfo> clips;
    const TemplateEntry known = handle.entry();
    const TemplatePtr asset = handle.asset();
    for (std::size_t i = 0; i < asset->clips.size(); ++i) {
        const Clip& clip = asset->clips[i];
        clips.push_back({clip.name, static_cast<double>(clip.seconds), clip.keyframeCount(),
                         static_cast<double>(clip.speed), clip.loop, clip.seatHeight,
                         keyOf(clipRole(known, i, i))});
    }
    return clips;
}

int clipIndex(const Template& asset, const std::variant<int, std::string>& clip)
{
    const auto count = static_cast<int>(asset.clips.size());
    if (const int* index = std::get_if<int>(&clip)) {
        if (*index < 0 || *index >= count) {
            throw ScriptError("Clip " + std::to_string(*index) + " is out of range: " + asset.name +
                              " has " + std::to_string(count) + ", counted from 0.");
        }
        return *index;
    }
    const auto& name = std::get<std::string>(clip);
    const auto found = std::ranges::find(asset.clips, name, &Clip::name);
    if (found == asset.clips.end()) {
        throw ScriptError("Template " + asset.name + " has no clip \"" + name + "\".");
    }
    return static_cast<int>(found - asset.clips.begin());
}

ExactKeyframe keyframeOf(const TemplateHandle& handle, const std::variant<int, std::string>& clip,
                         int k)
{
    const TemplatePtr asset = handle.asset();
    const int index = clipIndex(*asset, clip);
    const Clip& chosen = asset->clips[static_cast<std::size_t>(index)];
    if (k < 0 || k >= chosen.keyframeCount()) {
        throw ScriptError("Keyframe " + std::to_string(k) + " is out of range: " + chosen.name +
                          " has " + std::to_string(chosen.keyframeCount()) + ", counted from 0.");
    }
    return exactKeyframe(*asset, index, k);
}

py::array_t<float> toArray(const std::vector<glm::vec3>& vectors)
{
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    return py::array_t<float>({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}},
                              reinterpret_cast<const float*>(vectors.data()));
}

py::array_t<std::uint32_t> trianglesOf(const TemplateHandle& handle)
{
    const TemplatePtr asset = handle.asset();
    const std::vector<std::uint32_t>& indices = asset->levels.front().indices;
    return py::array_t<std::uint32_t>(
        {static_cast<py::ssize_t>(indices.size() / 3), py::ssize_t{3}}, indices.data());
}

template<class Items>
std::vector<std::string> namesOf(const Items& items)
{
    std::vector<std::string> names;
    names.reserve(items.size());
    for (const auto& item : items) {
        names.push_back(item.name);
    }
    return names;
}

std::vector<std::size_t> levelTriangles(const TemplateHandle& handle)
{
    std::vector<std::size_t> triangles;
    const TemplatePtr asset = handle.asset();
    for (const Mesh& level : asset->levels) {
        triangles.push_back(level.triangleCount());
    }
    return triangles;
}

void bindClip(py::module_& module)
{
    py::class_<ClipInfo>(module, "Clip", "An animation of a template, for reading.")
        .def_readonly("name", &ClipInfo::name)
        .def_readonly("seconds", &ClipInfo::seconds)
        .def_readonly("keyframes", &ClipInfo::keyframes, "Sampled 32 times a second.")
        .def_readonly("speed", &ClipInfo::speed, "Ground speed at playback speed 1, m/s.")
        .def_readonly("loop", &ClipInfo::loop)
        .def_readonly("seat_height", &ClipInfo::seatHeight, "Metres; None: it does not sit.")
        .def_readonly("role", &ClipInfo::role,
                      "What it is for: \"idle\", \"walk\", \"run\", \"fly\", \"sit\" or "
                      "\"other\".")
        .def("__repr__", [](const ClipInfo& clip) { return "<Clip " + clip.name + ">"; });
}

} // namespace

void bindTemplates(py::module_& module)
{
    using ClipKey = std::variant<int, std::string>;
    bindClip(module);
    py::class_<TemplateHandle>(module, "Template",
                               "A character of a scene, to make copies of. Follows undo: using one "
                               "whose template is gone raises Error.")
        .def_property_readonly("id", [](const TemplateHandle& t) { return t.id; })
        .def_property_readonly("name", [](const TemplateHandle& t) { return t.entry().name; })
        .def_property_readonly("path", [](const TemplateHandle& t) { return t.entry().path; })
        .def_property_readonly("clips", &clipsOf)
        .def_property_readonly(
            "clip_names", [](const TemplateHandle& t) { return t.entry().clipNames; },
            "What the column \"clip\" counts.")
        .def_property_readonly("slots",
                               [](const TemplateHandle& t) { return namesOf(t.asset()->slots); })
        .def_property_readonly(
            "parts", [](const TemplateHandle& t) { return namesOf(t.asset()->parts); },
            "Bit i of the column \"parts\" shows part i.")
        .def_property_readonly("levels", &levelTriangles, "Triangles of each level of detail.")
        .def_property_readonly("height_m",
                               [](const TemplateHandle& t) { return t.asset()->bounds.size().y; })
        .def_property_readonly("triangles", &trianglesOf, "T×3 uint32: vertex indices of level 0.")
        .def(
            "keyframe_vertices",
            [](const TemplateHandle& t, const ClipKey& clip, int k) {
                return toArray(keyframeOf(t, clip, k).positions);
            },
            py::arg("clip"), py::arg("k"),
            "V×3 float32: level 0 of keyframe k, metres, the template's own frame, file order.")
        .def(
            "keyframe_normals",
            [](const TemplateHandle& t, const ClipKey& clip, int k) {
                return toArray(keyframeOf(t, clip, k).normals);
            },
            py::arg("clip"), py::arg("k"), "V×3 float32: unit normals of the same vertices.")
        .def(
            "__eq__",
            [](const TemplateHandle& a, const TemplateHandle& b) {
                return a.owner == b.owner && a.id == b.id && a.birth == b.birth;
            },
            py::is_operator())
        .def("__hash__", [](const TemplateHandle& t) { return t.id; })
        .def("__repr__",
             [](const TemplateHandle& t) { return "<Template " + t.entry().name + ">"; });
}

} // namespace crowd::app
