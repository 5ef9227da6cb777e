// SPDX-License-Identifier: MIT
#include "app/python/Binding.h"
#include "app/python/ColumnArrays.h"
#include "app/python/ScriptFeatures.h"

namespace crowd::app {

using namespace model;

namespace {

float weightGiven(const py::handle& given)
{
    if (!py::isinstance<py::float_>(given) && !py::isinstance<py::int_>(given)) {
        throw ScriptError("A weight must be a number, not " +
                          shortly(py::reinterpret_borrow<py::object>(given)) + ".");
    }
    return given.cast<float>();
}

std::string nameGiven(const py::handle& given)
{
    if (!py::isinstance<py::str>(given)) {
        throw ScriptError("A value of a feature goes by its name, not " +
                          shortly(py::reinterpret_borrow<py::object>(given)) + ".");
    }
    return given.cast<std::string>();
}

/// A name, a dict of names with weights, a list of names or of pairs; None: none.
std::vector<NamedWeight> valuesGiven(const py::object& given)
{
    std::vector<NamedWeight> values;
    if (given.is_none()) {
        return values;
    }
    if (py::isinstance<py::str>(given)) {
        return {{given.cast<std::string>(), 1.0F}};
    }
    if (py::isinstance<py::dict>(given)) {
        for (const auto& [name, weight] : given.cast<py::dict>()) {
            values.push_back({nameGiven(name), weightGiven(weight)});
        }
    } else if (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) {
        for (const py::handle each : given) {
            const bool isPair = py::isinstance<py::tuple>(each) && py::len(each) == 2;
            const auto pair = isPair ? py::reinterpret_borrow<py::tuple>(each) : py::tuple();
            values.push_back(isPair ? NamedWeight{nameGiven(pair[0]), weightGiven(pair[1])}
                                    : NamedWeight{nameGiven(each), 1.0F});
        }
    } else {
        throw ScriptError("value must be a name, a dict of names and weights, a list of names, or "
                          "None, not " +
                          shortly(given) + ".");
    }
    if (values.empty()) {
        throw ScriptError("value names nothing: None takes the feature off.");
    }
    return values;
}

std::size_t setFeatureGiven(const ScenePtr& scene, const py::object& ids, const std::string& kind,
                            const py::object& value)
{
    std::vector<std::size_t> order;
    const auto people = idsFrom(*scene, ids, order);
    return valueOrRaise(setFeature(*scene, people, kind, valuesGiven(value)));
}

py::object featureGiven(const ScenePtr& scene, const std::string& kind)
{
    const auto names = valueOrRaise(featureNames(*scene->scene(), kind));
    return py::module_::import("numpy").attr("array")(py::cast(names), py::arg("dtype") = "U");
}

} // namespace

void bindFeatures(SceneClass& scene)
{
    scene
        .def("set_feature", &setFeatureGiven, py::arg("ids"), py::arg("kind"), py::arg("value"),
             "Lets these people bear a value of a feature, with all that it does to them: one undo "
             "step. value: its name; a dict of names and weights, or a list of names, one of which "
             "is drawn for each; None: they bear none any more, what it did to them stays. What a "
             "value names by clips, slots and parts that somebody has not is left as it is. How "
             "many changed. Raises Error for unknown names and dead ids.")
        .def("feature", &featureGiven, py::arg("kind"),
             "Names of the values of a feature that people bear, in the order of ids; \"\" for "
             "none. Raises Error where there is no such feature.")
        .def("_free_feature_id", [](const ScenePtr& self) { return freeFeatureId(*self->scene()); })
        .def("_free_kind_id", [](const ScenePtr& self) { return freeKindId(*self->scene()); });
}

} // namespace crowd::app
