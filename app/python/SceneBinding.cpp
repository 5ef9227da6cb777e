// SPDX-License-Identifier: MIT
#include <cmath>
#include <unordered_set>

#include "app/python/Binding.h"
#include "app/python/ColumnArrays.h"
#include "app/python/ColumnRules.h"
#include "app/python/LongCall.h"
#include "app/python/OutsidePython.h"
#include "app/python/ScriptPeople.h"
#include "model/project/LocateAssets.h"

namespace crowd::app {

using namespace model;

namespace {

MissingEntries missingIf(bool isAllowed)
{
    return isAllowed ? MissingEntries::Take : MissingEntries::Refuse;
}

py::array create(const ScenePtr& scene, const std::optional<std::size_t>& count, bool allowMissing,
                 const LongCall::Listener& progress, const py::kwargs& columns)
{
    if (count) {
        valueOrRaise(checkRoom(*scene->scene(), *count));
    }
    const GivenColumns given = columnsFrom(scene, columns, count, {});
    LongCall call(progress);
    auto created =
        createPeople(*scene, given.count, given.values, call.hook(), missingIf(allowMissing));
    call.raise();
    const std::vector<IndividualId> ids = valueOrRaise(std::move(created));
    return py::array_t<IndividualId>(static_cast<py::ssize_t>(ids.size()), ids.data());
}

void remove(const ScenePtr& scene, const py::object& idsOrMask)
{
    std::vector<std::size_t> order;
    valueOrRaise(removePeople(*scene, idsFrom(*scene, idsOrMask, order)));
}

int putOnGroundGiven(const ScenePtr& scene, const py::object& idsOrMask)
{
    const auto now = scene->scene();
    std::vector<std::size_t> order;
    const auto everybody = now->population.ids();
    const std::vector<IndividualId> ids =
        idsOrMask.is_none() ? std::vector<IndividualId>(everybody.begin(), everybody.end())
                            : idsFrom(*scene, idsOrMask, order);
    // Finding the ground takes long; what is read and edited then needs Python's lock, as all else.
    const ScriptScene::Snapshot seen = scene->snapshot();
    outsidePython([&] { (void)scene->ground().of(*seen.scene); });
    return valueOrRaise(putOnGround(*scene, ids));
}

void change(const ScenePtr& scene, const py::object& idsOrMask, bool allowMissing,
            const py::kwargs& columns)
{
    std::vector<std::size_t> order;
    const auto ids = idsFrom(*scene, idsOrMask, order);
    const auto now = scene->scene();
    std::vector<TemplateId> templates(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const std::size_t row = now->population.rowOf(ids[i]);
        if (row == Population::npos) {
            throw ScriptError("There is no individual " + std::to_string(ids[i]) +
                              ": it was removed or never created.");
        }
        templates[order[i]] = now->population.column(columns::templateId)[row];
    }
    GivenColumns given = columnsFrom(scene, columns, ids.size(), templates);
    reorder(given.values, order);
    LongCall call({});
    auto changed = changePeople(*scene, ids, given.values, call.hook(), missingIf(allowMissing));
    call.raise();
    valueOrRaise(std::move(changed));
}

void send(const ScenePtr& scene, const std::string& event, const py::object& ids, float number)
{
    valueOrRaise(scene->send(eventOf(*scene, event, ids, number)));
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

void warn(const std::string& text)
{
    if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) < 0) {
        throw py::error_already_set(); // the script wants them as errors
    }
}

/// What the editor shows in a dialog when it opens a scene.
void warnOfOddities(const Scene& scene)
{
    for (const model::Message& warning : scene.readWarnings) {
        warn(warning.english());
    }
    for (const MissingAsset& each : missingAssets(scene)) {
        warn((each.isStage ? "Stage \"" : "Template \"") + each.name +
             "\": " + each.problem.english());
    }
}

} // namespace

ScenePtr EditBlock::begin()
{
    valueOrRaise(m_scene->beginEdit(m_text));
    m_isOpen = true;
    return m_scene;
}

void EditBlock::end(bool isKept)
{
    if (std::exchange(m_isOpen, false)) {
        m_scene->endEdit(isKept);
    }
}

namespace {

void bindEdit(py::module_& module)
{
    py::class_<EditBlock>(module, "Edit", "What scene.edit(name) gives: for `with`.")
        .def("__enter__", &EditBlock::begin)
        .def("__exit__", [](EditBlock& block, const py::object& type, const py::object&,
                            const py::object&) { block.end(type.is_none()); });
}

void bindDocument(SceneClass& scene)
{
    scene.def(py::init<>(), "An empty scene.")
        .def(
            "save",
            [](const ScenePtr& s, const std::optional<FilePath>& path) {
                if (path && path->empty()) {
                    throw ScriptError("path is empty; leave it out to save to scene.path.");
                }
                valueOrRaise(s->save(path ? path->string() : std::string()));
            },
            py::arg("path") = py::none(),
            "Writes a .crowd file, whole or not at all. Without a path: where it was opened or "
            "saved "
            "last. Raises Error where the file cannot be written.")
        .def_property_readonly(
            "path", [](const ScenePtr& s) { return s->path(); },
            "The file that it was opened from or saved to; empty: none.")
        .def_property_readonly(
            "modified", [](const ScenePtr& s) { return s->isModified(); },
            "Whether there is something to save.")
        .def(
            "undo", [](const ScenePtr& s) { return valueOrRaise(s->undo()); },
            "Takes the last step back; False when there was nothing to undo. Raises Error inside "
            "an "
            "edit.")
        .def(
            "redo", [](const ScenePtr& s) { return valueOrRaise(s->redo()); },
            "False when there was nothing to redo.")
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
        .def_property_readonly(
            "ids", [](const ScenePtr& s) { return columnArray(s->scene()->population, "id"); },
            "N uint32, ascending.")
        .def(
            "column",
            [](const ScenePtr& s, const std::string& name) {
                return columnArray(s->scene()->population, name);
            },
            py::arg("name"),
            "A copy of a column for everybody, rows by ascending id: N numbers, N×3 float32 for "
            "position, N×8×4 uint8 for tint, N×4 for tint0 … tint7, N×8 for choices. Raises Error "
            "for an unknown name.")
        .def("create", &create, py::kw_only(), py::arg("count") = py::none(),
             py::arg("allow_missing") = false, py::arg("progress") = py::none(),
             "create(template=…, position=N×3, …) → ids. Columns by keyword, one value for all or "
             "one each; a seat brings position, heading and a sitting clip. count: how many, where "
             "no column says so. Raises Error, and creates nobody, for wrong shapes, values that "
             "are "
             "not finite, unknown templates and clips, seats that are taken, and groups and paths "
             "that "
             "the scene does not have, unless allow_missing. " CROWD_PROGRESS_DOC)
        .def("remove", &remove, py::arg("ids"),
             "By ids or by a mask over everybody. Raises Error for ids that are dead or named "
             "twice.")
        .def("change", &change, py::arg("ids"), py::kw_only(), py::arg("allow_missing") = false,
             "change(ids_or_mask, heading=…, …): columns by keyword, one value for all or one "
             "each, in the order of ids. Raises Error, and changes nothing, for dead ids, wrong "
             "shapes, values that are not finite, and groups and paths that the scene does not "
             "have, unless allow_missing.")
        .def("put_on_ground", &putOnGroundGiven, py::arg("ids") = py::none(),
             "Those of them, or of all, who stand where nobody can walk (on roofs, in basins, in "
             "the air) come to the nearest ground: one undo step. How many. Takes seconds where "
             "the stages are large. Raises Error for dead ids.")
        .def("send", &send, py::arg("event"), py::arg("ids") = py::none(), py::kw_only(),
             py::arg("number") = 0.0F,
             "An event happens to those who play in the editor's window: to these, or to "
             "everybody. Raises Error where nobody plays; without a window a Session is what "
             "plays.")
        .def_property_readonly(
            "seats", &seats,
            "Arrays by name: id, position (N×3, metres), heading (radians), rank, wedge, and "
            "free (bool).");
}

} // namespace

void bindScene(py::module_& module)
{
    SceneClass scene(module, "Scene", "A document: people, templates, stages, cameras, history.");
    bindEdit(module);
    bindDocument(scene);
    bindPopulation(scene);
    bindPictures(module, scene);
    bindMovies(scene);
    bindTakes(module, scene);
    bindContents(module, scene);
    bindEnvironment(scene);
    bindStrokes(module, scene);
    bindStates(module, scene);
    bindFeatures(scene);
    bindRelations(scene);
    module.def(
        "open",
        [](const FilePath& path) {
            auto opened = std::make_shared<ScriptScene>();
            valueOrRaise(opened->open(path.string()));
            warnOfOddities(*opened->scene());
            return opened;
        },
        py::arg("path"),
        "Opens a .crowd file, or a ready-made scene such as builtin:scenes/theatre.crowd. Raises "
        "Error with the reason why it cannot be read; warns (UserWarning) of stages and templates "
        "that could not be loaded, and of what in the file was odd.");
}

} // namespace crowd::app
