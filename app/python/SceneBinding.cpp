// SPDX-License-Identifier: MIT
#include <cmath>
#include <unordered_set>

#include "app/python/Binding.h"
#include "app/python/ColumnArrays.h"

namespace crowd::app {

using namespace model;

namespace {

/// `with scene.edit("name"):` one undo step, or nothing at all when the block raises.
struct EditBlock
{
    ScenePtr scene;
    std::string text;
};

py::array create(const ScenePtr& scene, const py::kwargs& columns)
{
    const GivenColumns given = columnsFrom(*scene->scene(), columns, std::nullopt, {});
    const auto ids = valueOrRaise(scene->create(given.count, given.values));
    return py::array_t<IndividualId>(static_cast<py::ssize_t>(ids.size()), ids.data());
}

void remove(const ScenePtr& scene, const py::object& idsOrMask)
{
    const auto now = scene->scene();
    std::vector<std::size_t> order;
    valueOrRaise(scene->remove(idsFrom(*now, idsOrMask, order)));
}

void change(const ScenePtr& scene, const py::object& idsOrMask, const py::kwargs& columns)
{
    const auto now = scene->scene();
    std::vector<std::size_t> order;
    const auto ids = idsFrom(*now, idsOrMask, order);
    std::vector<TemplateId> templates(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const std::size_t row = now->population.rowOf(ids[i]);
        if (row == Population::npos) {
            throw ScriptError("There is no individual " + std::to_string(ids[i]) +
                              ": it was removed or never created.");
        }
        templates[order[i]] = now->population.column(columns::templateId)[row];
    }
    GivenColumns given = columnsFrom(*now, columns, ids.size(), templates);
    reorder(given.values, order);
    valueOrRaise(scene->change(ids, given.values));
}

py::dict seats(const ScenePtr& scene)
{
    const auto now = scene->scene();
    const std::vector<WorldSeat> all = now->worldSeats();
    const auto n = static_cast<py::ssize_t>(all.size());
    const auto used = now->population.column(columns::seat);
    const std::unordered_set<SeatId> taken(used.begin(), used.end());
    py::array_t<SeatId> ids(n);
    py::array_t<float> positions({n, py::ssize_t{3}});
    py::array_t<float> headings(n);
    py::array_t<int> ranks(n);
    py::array_t<int> wedges(n);
    py::array_t<bool> free(n);
    for (py::ssize_t i = 0; i < n; ++i) {
        const WorldSeat& seat = all[static_cast<std::size_t>(i)];
        *ids.mutable_data(i) = seat.id;
        for (int axis = 0; axis < 3; ++axis) {
            *positions.mutable_data(i, axis) = seat.seat.position[axis];
        }
        *headings.mutable_data(i) = seat.seat.headingRadians;
        *ranks.mutable_data(i) = seat.seat.rank;
        *wedges.mutable_data(i) = seat.seat.wedge;
        *free.mutable_data(i) = !taken.contains(seat.id);
    }
    py::dict table;
    table["id"] = ids;
    table["position"] = positions;
    table["heading"] = headings;
    table["rank"] = ranks;
    table["wedge"] = wedges;
    table["free"] = free;
    return table;
}

std::vector<TemplateHandle> templates(const ScenePtr& scene)
{
    std::vector<TemplateHandle> handles;
    const auto now = scene->scene();
    for (const TemplateEntry& entry : now->templates) {
        handles.push_back({scene, entry.id});
    }
    return handles;
}

void bindEdit(py::module_& module)
{
    py::class_<EditBlock>(module, "Edit")
        .def("__enter__",
             [](const EditBlock& block) {
                 valueOrRaise(block.scene->beginEdit(block.text));
                 return block.scene;
             })
        .def("__exit__", [](const EditBlock& block, const py::object& type, const py::object&,
                            const py::object&) { block.scene->endEdit(type.is_none()); });
}

void bindDocument(SceneClass& scene)
{
    scene.def(py::init<>(), "An empty scene.")
        .def(
            "save", [](const ScenePtr& s, const std::string& path) { valueOrRaise(s->save(path)); },
            py::arg("path") = "", "Without a path: where it was opened or saved last.")
        .def_property_readonly("path", [](const ScenePtr& s) { return s->path(); })
        .def_property_readonly("modified", [](const ScenePtr& s) { return s->isModified(); })
        .def(
            "undo", [](const ScenePtr& s) { return valueOrRaise(s->undo()); },
            "False when there was nothing to undo.")
        .def("redo", [](const ScenePtr& s) { return valueOrRaise(s->redo()); })
        .def_property_readonly(
            "history", [](const ScenePtr& s) { return s->history(); },
            "Texts of all steps, oldest first.")
        .def_property_readonly(
            "history_index", [](const ScenePtr& s) { return s->historyIndex(); },
            "How many steps are done.")
        .def(
            "edit",
            [](const ScenePtr& s, const std::string& name) {
                return EditBlock{s, name};
            },
            py::arg("name"),
            "with scene.edit(\"name\"): all changes become one undo step; an exception takes them "
            "back.");
}

void bindPopulation(SceneClass& scene)
{
    scene.def("__len__", [](const ScenePtr& s) { return s->scene()->population.size(); })
        .def_property_readonly("ids",
                               [](const ScenePtr& s) { return columnArray(*s->scene(), "id"); })
        .def(
            "column",
            [](const ScenePtr& s, const std::string& name) {
                return columnArray(*s->scene(), name);
            },
            py::arg("name"), "A copy of a column for everybody, by ascending id.")
        .def("create", &create,
             "create(template=…, position=N×3, …) → ids. Columns by keyword, one value for all or "
             "one each; a seat brings position, heading and a sitting clip.")
        .def("remove", &remove, py::arg("ids"), "By ids or by a mask over everybody.")
        .def("change", &change, py::arg("ids"),
             "change(ids_or_mask, heading=…, …): columns by keyword, one value for all or one "
             "each.")
        .def_property_readonly("seats", &seats,
                               "Arrays id, position (N×3), heading, rank, wedge, free.");
}

void bindContents(SceneClass& scene)
{
    scene.def_property_readonly("templates", &templates)
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
            py::arg("name"))
        .def(
            "add_template",
            [](const ScenePtr& s, const std::string& path, const std::string& name) {
                return TemplateHandle{s, valueOrRaise(s->addTemplate(path, name))};
            },
            py::arg("path"), py::arg("name") = "",
            "A .glb or .gltf file, or a built-in one such as builtin:templates/man.glb.")
        .def(
            "add_stage",
            [](const ScenePtr& s, const std::string& path, const std::string& name,
               const Point3& position, float heading, float scale) {
                StageEntry entry;
                entry.path = path;
                entry.name = name;
                entry.position = toVector(position, "position");
                if (!std::isfinite(heading) || !(scale > 0.0F && std::isfinite(scale))) {
                    throw ScriptError("A stage needs a finite heading and a scale above zero.");
                }
                entry.headingRadians = heading;
                entry.scale = scale;
                valueOrRaise(s->addStage(entry));
            },
            py::arg("path"), py::arg("name") = "", py::arg("position") = Point3{0, 0, 0},
            py::arg("heading") = 0.0F, py::arg("scale") = 1.0F)
        .def_property_readonly("stages",
                               [](const ScenePtr& s) {
                                   std::vector<std::string> names;
                                   const auto now = s->scene();
                                   for (const StageEntry& stage : now->stages) {
                                       names.push_back(stage.name);
                                   }
                                   return names;
                               })
        .def_property_readonly("cameras",
                               [](const ScenePtr& s) {
                                   py::dict cameras;
                                   const auto now = s->scene();
                                   for (const NamedCamera& each : now->cameras) {
                                       cameras[py::str(each.name)] = each.camera;
                                   }
                                   return cameras;
                               })
        .def(
            "set_camera",
            [](const ScenePtr& s, const std::string& name, const Camera& camera) {
                valueOrRaise(s->setCamera(name, camera));
            },
            py::arg("name"), py::arg("camera"));
}

} // namespace

void bindScene(py::module_& module)
{
    SceneClass scene(module, "Scene", "A document: people, templates, stages, cameras, history.");
    bindEdit(module);
    bindDocument(scene);
    bindPopulation(scene);
    bindContents(scene);
    bindPictures(module, scene);
    bindStrokes(module, scene);
    module.def(
        "open",
        [](const std::string& path) {
            auto opened = std::make_shared<ScriptScene>();
            valueOrRaise(opened->open(path));
            return opened;
        },
        py::arg("path"),
        "Opens a .crowd file, or a ready-made scene such as builtin:scenes/theatre.crowd.");
}

} // namespace crowd::app
