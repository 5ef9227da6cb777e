// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <vector>

#include "app/python/Binding.h"
#include "app/python/ColumnArrays.h"
#include "app/python/LongCall.h"
#include "app/python/OutsidePython.h"
#include "app/python/ScriptTakes.h"
#include "model/project/HandEditJson.h"

namespace crowd::app {

using namespace model;

namespace {

std::vector<Take> takesOf(const ScenePtr& scene)
{
    return scene->scene()->takes;
}

Take keepGiven(ScriptSession& session, const std::string& name, const LongCall::Listener& progress)
{
    LongCall call(progress);
    auto kept = keepTake(session, name, call.hook());
    call.raise();
    return valueOrRaise(std::move(kept));
}

py::object editsOf(const Take& take)
{
    return callPython(py::module_::import("json").attr("loads"),
                      py::make_tuple(handEditsText(take.edits)));
}

/// A list of dicts, or JSON text.
std::string editsText(const py::object& given)
{
    if (py::isinstance<py::str>(given)) {
        return given.cast<std::string>();
    }
    try {
        return callPython(py::module_::import("json").attr("dumps"), py::make_tuple(given))
            .cast<std::string>();
    } catch (py::error_already_set& problem) {
        if (problem.matches(PyExc_TypeError) || problem.matches(PyExc_ValueError)) {
            throw ScriptError("Edits are a list of dicts as take.edits gives it, or JSON text: " +
                              std::string(py::str(problem.value())) + ".");
        }
        throw;
    }
}

Take retakeGiven(const ScenePtr& scene, const std::string& take, const std::string& name,
                 const py::object& idsOrMask, double begin, double end, bool isDifferent,
                 const LongCall::Listener& progress)
{
    std::vector<std::size_t> order;
    const ScriptRetake wish{
        take, name, {idsFrom(*scene, idsOrMask, order), begin, end, isDifferent}};
    LongCall call(progress);
    auto made = retake(*scene, wish, call.hook());
    call.raise();
    return valueOrRaise(std::move(made));
}

constexpr const char* kRetakeDoc =
    "Some people of a take, by ids or a mask over everybody, are simulated again from begin to "
    "end, seconds of the clock, by the rules and paths of now; everybody else does what he did, "
    "and "
    "they make way for him. They set out as they are then and come back to where they were where "
    "more of the take follows. What comes of it is another take, one undo step; returns it. "
    "different: dice fall otherwise than in the run. Raises Error where there is no such take, the "
    "name is another's, nobody is chosen or the stretch lies outside. " CROWD_PROGRESS_DOC;

constexpr const char* kEditDoc =
    "What is done to people of the take by hand, instead of what was done so far: a list "
    "of dicts, or JSON text. kind: \"shift\" (later: seconds), \"pace\" (pace: times as "
    "fast; 0: they stand still), \"aside\" (aside: metres to the right), \"swap\" (templates: "
    "ids of those that they are of meanwhile) or \"hide\"; people: their ids, ascending; begin and "
    "end: seconds of the clock, of all but \"shift\" "
    "(an end that is not after the beginning: to the end of the take); on: whether it counts. They "
    "survive it when people are taken again. on=False: none of them counts. Raises Error "
    "for what is none, and where there is no such take.";

void bindTake(py::module_& module)
{
    py::class_<Take>(module, "Take",
                     "A run that was kept, to be shown again whatever becomes of paths and rules; "
                     "as it was when it was asked for.")
        .def_readonly("name", &Take::name)
        .def_readonly("begin", &Take::begin, "Seconds of the clock of its first step.")
        .def_readonly("end", &Take::end, "Seconds of the clock of its last step.")
        .def_readonly("people", &Take::people, "How many it moves.")
        .def_readonly("shown", &Take::isShown, "Whether it is seen instead of a run.")
        .def_property_readonly(
            "problem", [](const Take& take) { return take.problem.english(); },
            "Why its motion is not there; empty: it is.")
        .def_property_readonly(
            "edits", &editsOf,
            "list of dict: what is done to people of it by hand, see Scene.edit_take.")
        .def_readonly("edited", &Take::areEditsOn, "Whether its edits count.")
        .def("__repr__", [](const Take& take) {
            return "<Take \"" + take.name + "\" of " + std::to_string(take.people) + ">";
        });
}

} // namespace

void bindTakes(py::module_& module, SceneClass& scene)
{
    bindTake(module);
    scene
        .def_property_readonly("takes", &takesOf,
                               "list of Take: kept runs. Their motion is in files in a folder "
                               "beside the project.")
        .def(
            "show_take",
            [](const ScenePtr& self, const std::optional<std::string>& name) {
                valueOrRaise(showTake(*self, name));
            },
            py::arg("name"),
            "People move as in that take: in the window, in pictures and movies. None: as the "
            "scene plays. Raises Error where there is none, or its motion is not there.")
        .def(
            "add_take",
            [](const ScenePtr& self, const FilePath& path, const std::string& name, TakeId id) {
                return valueOrRaise(addTake(*self, path.string(), name, id));
            },
            py::arg("path"), py::arg("name"), py::kw_only(), py::arg("id") = TakeId{0},
            "A .take file, of this project or another one, becomes a take of this scene; saving "
            "brings it into the project's folder of takes. It moves those who have the same ids.")
        .def(
            "rename_take",
            [](const ScenePtr& self, const std::string& name, const std::string& to) {
                valueOrRaise(renameTake(*self, name, to));
            },
            py::arg("name"), py::arg("to"), "Raises Error where another one has that name.")
        .def(
            "edit_take",
            [](const ScenePtr& self, const std::string& name, const py::object& edits, bool on) {
                valueOrRaise(setHandEdits(*self, name, editsText(edits), on));
            },
            py::arg("name"), py::arg("edits"), py::kw_only(), py::arg("on") = true, kEditDoc)
        .def("retake", &retakeGiven, py::arg("take"), py::arg("name"), py::arg("ids"),
             py::arg("begin"), py::arg("end"), py::kw_only(), py::arg("different") = false,
             py::arg("progress") = py::none(), kRetakeDoc)
        .def(
            "remove_take",
            [](const ScenePtr& self, const std::string& name) {
                valueOrRaise(removeTake(*self, name));
            },
            py::arg("name"), "The file with its motion stays.");
}

void bindTakeKeeping(SessionClass& session)
{
    session.def("keep_take", &keepGiven, py::arg("name"), py::kw_only(),
                py::arg("progress") = py::none(),
                "What the session has done so far becomes a take of its scene: one undo step. It "
                "needs to record (Session(scene, record=True)). Returns the Take. "
                "" CROWD_PROGRESS_DOC);
}

} // namespace crowd::app
