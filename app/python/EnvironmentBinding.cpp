// SPDX-License-Identifier: MIT
#include <cmath>

#include <pybind11/eval.h>

#include "BrushesSource.h"
#include "app/python/Binding.h"
#include "app/python/OutsidePython.h"
#include "app/python/ScriptEnvironment.h"
#include "model/project/EnvironmentSchema.h"
#include "model/project/EnvironmentText.h"

namespace crowd::app {

using namespace model;

namespace {

py::object environment(const ScenePtr& scene)
{
    return callPython(py::module_::import("json").attr("loads"),
                      py::make_tuple(environmentText(*scene->scene())));
}

constexpr std::size_t kDeepest = 64; ///< as project files

/// Raises where a number has no finite value, naming its place: JSON has no words for those. Also
/// where there is no end to it: what holds itself.
class EnvironmentCheck
{
public:
    void check(const py::handle& value)
    {
        if (py::isinstance<py::float_>(value) && !std::isfinite(PyFloat_AS_DOUBLE(value.ptr()))) {
            throw ScriptError(place() + " must be a finite number.");
        }
        if (py::isinstance<py::dict>(value)) {
            const auto items = py::reinterpret_borrow<py::dict>(value);
            for (const auto& [key, item] : items) {
                checkPart(py::reinterpret_borrow<py::object>(key), item);
            }
        } else if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
            std::size_t index = 0;
            for (const py::handle item : value) {
                checkPart(py::int_(index++), item);
            }
        }
    }

private:
    void checkPart(const py::object& key, const py::handle& item)
    {
        if (!py::isinstance<py::dict>(item) && !py::isinstance<py::list>(item) &&
            !py::isinstance<py::tuple>(item) && !py::isinstance<py::float_>(item)) {
            return;
        }
        m_way.push_back(key);
        if (m_way.size() > kDeepest) {
            throw ScriptError("The environment is nested more than " + std::to_string(kDeepest) +
                              " deep, or holds itself.");
        }
        check(item);
        m_way.pop_back();
    }
    [[nodiscard]] std::string place() const
    {
        std::string text = "environment";
        for (const py::object& key : m_way) {
            const std::string part(py::str(key).cast<std::string>());
            text += py::isinstance<py::int_>(key) ? "[" + part + "]" : "." + part;
        }
        return text;
    }

    std::vector<py::object> m_way;
};

/// As json.dumps has it; what JSON does not know is refused in words.
std::string environmentJson(const py::object& given)
{
    if (py::isinstance<py::str>(given)) {
        return given.cast<std::string>();
    }
    if (!py::isinstance<py::dict>(given)) {
        throw ScriptError("An environment is a dict as scene.environment gives it, or JSON text, "
                          "not " +
                          shortly(given) + ".");
    }
    EnvironmentCheck().check(given);
    try {
        return callPython(py::module_::import("json").attr("dumps"), py::make_tuple(given))
            .cast<std::string>();
    } catch (py::error_already_set& problem) {
        if (problem.matches(PyExc_TypeError) || problem.matches(PyExc_ValueError)) {
            throw ScriptError("The environment holds what JSON cannot: " +
                              std::string(py::str(problem.value())) + ".");
        }
        throw;
    }
}

void setEnvironmentGiven(const ScenePtr& scene, const py::object& given, bool isStrict)
{
    valueOrRaise(setEnvironment(*scene, environmentJson(given), isStrict));
}

} // namespace

void bindEnvironment(SceneClass& scene)
{
    scene
        .def_property_readonly(
            "environment", &environment,
            "A dict of lists as the project file has them: places, paths, groups, tags, "
            "rules, numbers, cues, the surface to walk on, stepsPerSecond, and playRange (begin, "
            "end in seconds, and loop: what the editor plays). scene.rules and so on give the "
            "lists as typed classes.")
        .def(
            "set_environment", &setEnvironmentGiven, py::arg("environment"), py::kw_only(),
            py::arg("strict") = true,
            "Lists of places, paths, groups, tags, rules and so on as in environment, or the same "
            "as JSON "
            "text; what is not in it stays. What stands in them are dicts, or Rule, Place and so "
            "on. Raises Error where a member is wrong, or misspelt, or a rule names a clip or slot "
            "that no template has. strict=False takes what a project file may hold: members of a "
            "later version, clips of templates that are gone.")
        .def(
            "add_rules",
            [](const ScenePtr& self, const std::string& key) {
                return valueOrRaise(addRuleSet(*self, key));
            },
            py::arg("key"),
            ("Ready-made rules with their cues, as the editor's panel adds them: made for the "
             "clips "
             "and places that the scene has. Their ids. There are: " +
             ruleSetKeys() + ".")
                .c_str());
}

void bindEntries(py::module_& module)
{
    module.def("_environment_schema", &environmentSchema);
    py::exec(kEntriesSource, module.attr("__dict__"));
}

} // namespace crowd::app
