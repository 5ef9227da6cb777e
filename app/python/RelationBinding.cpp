// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <optional>

#include "app/python/Binding.h"
#include "app/python/ColumnArrays.h"
#include "app/python/ScriptRelations.h"

namespace crowd::app {

using namespace model;

namespace {

/// Ids in the order in which they are given, each as often as it is; a mask means those it holds.
std::vector<IndividualId> orderedIds(const ScriptScene& scene, const py::object& given)
{
    std::vector<std::size_t> order;
    const std::vector<IndividualId> sorted = idsFrom(scene, given, order);
    std::vector<IndividualId> ids(sorted.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        ids[order[i]] = sorted[i];
    }
    return ids;
}

/// Ascending, each once.
std::vector<IndividualId> idSet(const ScriptScene& scene, const py::object& given)
{
    std::vector<std::size_t> order;
    std::vector<IndividualId> ids = idsFrom(scene, given, order);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

std::vector<float> strengthsGiven(const py::object& given)
{
    const auto array =
        py::array_t<double, py::array::forcecast>::ensure(arrayOf("strength", given));
    if (!array || array.ndim() > 1) {
        throw ScriptError("strength must be a number from 0 to 1, or an array of such, not " +
                          shortly(given) + ".");
    }
    std::vector<float> strengths;
    for (py::ssize_t i = 0; i < array.size(); ++i) {
        const double value = array.data()[i];
        if (!(value >= 0.0 && value <= 1.0)) {
            throw ScriptError("strength must lie from 0 to 1, not be " + std::to_string(value) +
                              ".");
        }
        strengths.push_back(static_cast<float>(value));
    }
    return strengths;
}

std::size_t relateGiven(const ScenePtr& scene, const py::object& from, const py::object& to,
                        const std::string& name, const py::object& strength)
{
    const GivenRelations given{orderedIds(*scene, from), orderedIds(*scene, to),
                               strengthsGiven(strength)};
    return valueOrRaise(relate(*scene, given, name));
}

std::size_t unrelateGiven(const ScenePtr& scene, const py::object& from, const py::object& to,
                          const std::optional<std::string>& name)
{
    std::optional<std::vector<IndividualId>> others;
    if (!to.is_none()) {
        others = orderedIds(*scene, to);
    }
    return valueOrRaise(unrelate(*scene, orderedIds(*scene, from), others, name));
}

template<class Value>
py::array arrayFrom(const std::vector<Value>& values)
{
    return py::array_t<Value>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::dict relationsGiven(const ScenePtr& scene)
{
    const auto now = scene->scene();
    std::vector<IndividualId> from;
    std::vector<IndividualId> to;
    std::vector<float> strength;
    std::vector<std::string> names;
    for (const Relation& each : now->relations.all()) {
        from.push_back(each.from);
        to.push_back(each.to);
        strength.push_back(each.strength);
        const RelationKind* kind = findRelation(now->relationKinds, each.kind);
        names.push_back(kind != nullptr ? kind->name : std::string());
    }
    py::dict all;
    all["from"] = arrayFrom(from);
    all["to"] = arrayFrom(to);
    all["name"] =
        py::module_::import("numpy").attr("array")(py::cast(names), py::arg("dtype") = "U");
    all["strength"] = arrayFrom(strength);
    return all;
}

py::array relatedGiven(const ScenePtr& scene, const py::object& ids,
                       const std::optional<std::string>& name)
{
    return arrayFrom(valueOrRaise(related(*scene->scene(), idSet(*scene, ids), name)));
}

py::array duplicateGiven(const ScenePtr& scene, const py::object& ids,
                         const std::array<float, 3>& offset)
{
    return arrayFrom(valueOrRaise(
        duplicatePeople(*scene, idSet(*scene, ids), {offset[0], offset[1], offset[2]})));
}

} // namespace

void bindRelations(SceneClass& scene)
{
    scene
        .def("relate", &relateGiven, py::arg("from_ids"), py::arg("to_ids"), py::arg("name"),
             py::arg("strength") = 1.0,
             "Relates people by a kind of relation: the first of from_ids to the first of to_ids "
             "and so on; one stands for all. One undo step. strength: 0 to 1, a number or one for "
             "each. Who is related so already gets the new strength. How many relations are "
             "another way. Raises Error for unknown names, dead ids, and lists that do not fit.")
        .def("unrelate", &unrelateGiven, py::arg("from_ids"), py::arg("to_ids") = py::none(),
             py::arg("name") = py::none(),
             "Takes relations away from from_ids to to_ids, one for one; without to_ids all that "
             "from_ids have, whichever way they go. name: of that kind alone. One undo step. "
             "How many there were.")
        .def("related", &relatedGiven, py::arg("ids"), py::arg("name") = py::none(),
             "Ids of those to whom one of these is related, ascending; of a kind that is not "
             "mutual those that it goes to. name: by that kind alone.")
        .def("duplicate", &duplicateGiven, py::arg("ids"),
             py::arg("offset") = std::array<float, 3>{1.0F, 0.0F, 0.0F},
             "Copies of these people, offset metres away, related among each other as these are: "
             "one undo step. Of those who sit on the free seats nearest to there; where none is "
             "near they stand. Their ids, in the order of these.")
        .def_property_readonly(
            "relations", &relationsGiven,
            "All relations as a dict of arrays, \"from\", \"to\", \"name\" and \"strength\", in "
            "the order of the ids. Copies: relate() and unrelate() change them.")
        .def("_free_relation_id",
             [](const ScenePtr& self) { return freeRelationId(self->scene()->relationKinds); });
}

} // namespace crowd::app
