// SPDX-License-Identifier: MIT
#include "app/python/Binding.h"
#include "app/python/ColumnArrays.h"
#include "app/python/FieldBinding.h"
#include "app/python/ScriptStates.h"
#include "model/describe/FieldChecks.h"

namespace crowd::app {

using namespace model;

/// crowdbrush.State: as it was when it was asked for.
struct StateHandle
{
    State state;

    [[nodiscard]] std::vector<std::string> columnNames() const
    {
        std::vector<std::string> names;
        state.columns.forEach(
            [&names](ColumnId column) { names.emplace_back(columnInfo(column).name); });
        return names;
    }
};

/// crowdbrush.States: those of a scene, by their names.
struct ScriptStates
{
    ScenePtr scene;

    [[nodiscard]] std::vector<std::string> names() const
    {
        const auto now = scene->scene();
        std::vector<std::string> all;
        for (const State& each : now->states) {
            all.push_back(each.name);
        }
        return all;
    }
};

namespace {

py::array valuesOf(const StateHandle& handle, const std::string& name)
{
    Population people;
    people.add(handle.state.people->unpacked());
    const auto names = handle.columnNames();
    const bool isTint = name == "tint" && handle.state.columns.contains(ColumnId::Tint0);
    if (name != "id" && !isTint && std::ranges::find(names, name) == names.end()) {
        throw ScriptError("The state \"" + handle.state.name + "\" does not hold \"" + name +
                          "\".");
    }
    return columnArray(std::move(people), name);
}

StateHandle stateNamed(const ScriptStates& states, const std::string& name)
{
    const auto now = states.scene->scene();
    const State* found = findState(*now, name);
    if (found == nullptr) {
        throw py::key_error("There is no state \"" + name + "\".");
    }
    return {*found};
}

ColumnSet columnsGiven(const std::optional<std::vector<std::string>>& names)
{
    return valueOrRaise(stateColumns(names ? &*names : nullptr));
}

/// Nothing: everybody.
std::optional<std::vector<IndividualId>> idsGiven(const ScenePtr& scene, const py::object& ids)
{
    if (ids.is_none()) {
        return std::nullopt;
    }
    std::vector<std::size_t> order;
    return idsFrom(*scene, ids, order);
}

void saveStateGiven(const ScenePtr& scene, const std::string& name,
                    const std::optional<std::vector<std::string>>& columns, const py::object& ids)
{
    const auto people = idsGiven(scene, ids);
    valueOrRaise(saveState(*scene, name, columnsGiven(columns), people ? &*people : nullptr));
}

StateRecall recallStateGiven(const ScenePtr& scene, const std::string& name, float seconds,
                             const std::optional<Stagger>& stagger, const py::object& ids,
                             const std::optional<std::vector<std::string>>& columns)
{
    return valueOrRaise(
        recallState(*scene, name, recallOrderOf(*scene, seconds, stagger, ids, columns)));
}

/// `order` by the key of its choice.
Stagger staggerOf(float seconds, const std::string& order, std::array<float, 3> point,
                  float heading)
{
    Stagger stagger{seconds, {}, {point[0], point[1], point[2]}, heading};
    const auto named = std::ranges::find(Stagger::kOrders, order, &FieldChoice::key);
    if (named == Stagger::kOrders.end()) {
        throw ScriptError("order is \"distance\", \"heading\", \"row\", \"wedge\" or "
                          "\"random\".");
    }
    stagger.order = static_cast<StaggerOrder>(named - Stagger::kOrders.begin());
    valueOrRaise(checkFields(fieldsOf<Stagger>(), &stagger, "stagger."));
    return stagger;
}

void bindStagger(py::module_& module)
{
    auto type = bindStruct<Stagger, Stagger>(
        module, "Stagger", "People take on a state one after the other.", fieldsOf<Stagger>());
    type.def(py::init(&staggerOf), py::arg("seconds"), py::arg("order") = "distance",
             py::arg("point") = std::array<float, 3>{}, py::arg("heading") = 0.0F,
             "The last begins so many seconds after the first. order: distance (from point), "
             "heading (in which it moves on, radians), row or wedge (of the seats), random.");
}

void bindState(py::module_& module)
{
    py::class_<StateHandle>(module, "State",
                            "How some people were in some of their properties, as it was when it "
                            "was asked for.")
        .def_property_readonly("name", [](const StateHandle& each) { return each.state.name; })
        .def_property_readonly(
            "id", [](const StateHandle& each) { return each.state.id; },
            "Its name within the scene, which stays: as rules, cues and the restore brush have "
            "it.")
        .def_property_readonly("columns", &StateHandle::columnNames,
                               "Names of the columns that it gives back.")
        .def_property_readonly(
            "ids",
            [](const StateHandle& each) {
                const auto& ids = each.state.people->ids;
                return py::array_t<IndividualId>(static_cast<py::ssize_t>(ids.size()), ids.data());
            },
            "Whose they are, ascending; some may be gone.")
        .def(
            "__len__", [](const StateHandle& each) { return each.state.people->ids.size(); },
            "How many people it is of.")
        .def("column", &valuesOf, py::arg("name"),
             "What it holds, as Scene.column has it, in the order of ids. Raises Error for what it "
             "does not hold.");
    py::class_<StateRecall>(module, "StateRecall", "What came of giving a state back.")
        .def_property_readonly(
            "affected", [](const StateRecall& recall) { return recall.changed.size(); },
            "How many people changed.")
        .def_property_readonly(
            "notes",
            [](const StateRecall& recall) {
                std::vector<std::string> notes;
                for (const Message& each : recall.notes) {
                    notes.push_back(each.english());
                }
                return notes;
            },
            "What did not fit any more.");
}

void bindMapping(py::module_& module)
{
    py::class_<ScriptStates>(module, "States",
                             "The states of a scene by their names, in the order of the panel.")
        .def("__getitem__", &stateNamed, py::arg("name"))
        .def(
            "__delitem__",
            [](const ScriptStates& states, const std::string& name) {
                valueOrRaise(removeState(*states.scene, name));
            },
            py::arg("name"), "One undo step.")
        .def("__contains__",
             [](const ScriptStates& states, const std::string& name) {
                 return findState(*states.scene->scene(), name) != nullptr;
             })
        .def("__len__", [](const ScriptStates& states) { return states.names().size(); })
        .def("__iter__",
             [](const ScriptStates& states) { return py::iter(py::cast(states.names())); })
        .def("keys", &ScriptStates::names, "The names, in their order.")
        .def(
            "rename",
            [](const ScriptStates& states, const std::string& name, const std::string& to) {
                valueOrRaise(renameState(*states.scene, name, to));
            },
            py::arg("name"), py::arg("to"), "One undo step.")
        .def(
            "arrange",
            [](const ScriptStates& states, const std::vector<std::string>& names) {
                valueOrRaise(arrangeStates(*states.scene, names));
            },
            py::arg("names"), "All names in another order: one undo step.")
        .def(
            "text",
            [](const ScriptStates& states) { return statesText(states.scene->scene()->states); },
            "All of them as the text of a project file with nothing else.")
        .def(
            "set_text",
            [](const ScriptStates& states, const std::string& text) {
                valueOrRaise(setStates(*states.scene, text));
            },
            py::arg("text"), "What text() gave, in place of what there is: one undo step.");
}

} // namespace

RecallOrder recallOrderOf(const ScriptScene& scene, float seconds,
                          const std::optional<Stagger>& stagger, const py::object& ids,
                          const std::optional<std::vector<std::string>>& columns)
{
    RecallOrder order;
    if (columns) {
        order.columns = columnsGiven(columns);
    }
    if (!ids.is_none()) {
        std::vector<std::size_t> given;
        order.ids = idsFrom(scene, ids, given);
    }
    order.timing = {seconds, stagger.value_or(Stagger())};
    return order;
}

void bindStates(py::module_& module, SceneClass& scene)
{
    bindStagger(module);
    bindState(module);
    bindMapping(module);
    scene
        .def_property_readonly(
            "states", [](const ScenePtr& self) { return ScriptStates{self}; },
            "Kept states by name.")
        .def("save_state", &saveStateGiven, py::arg("name"), py::arg("columns") = py::none(),
             py::arg("ids") = py::none(),
             "Keeps how these people are now, or all of them: one undo step. columns: names; "
             "without, everything but who and where they are (template, position, heading, seat, "
             "group, seed). A state of that name is replaced. Raises Error for unknown columns and "
             "dead ids.")
        .def("recall_state", &recallStateGiven, py::arg("name"), py::arg("seconds") = 0.0F,
             py::arg("stagger") = py::none(), py::arg("ids") = py::none(), py::kw_only(),
             py::arg("columns") = py::none(),
             "Gives them back what they had: one undo step. columns, ids: these alone. Clips, "
             "slots and parts go by name; who is gone is skipped. seconds, stagger: the scene "
             "changes at once, but in its sessions, and where the editor plays, each takes so "
             "long, one after the other. Raises Error where there is no such state, and for dead "
             "ids.");
}

} // namespace crowd::app
