// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "app/python/FieldBinding.h"
#include "app/python/OutsidePython.h"
#include "app/python/PythonBrush.h"
#include "model/brush/BrushJson.h"
#include "model/scene/NearestPath.h"

namespace crowd::app {

using namespace model;

namespace {

using BrushClass = py::class_<PythonBrush>;

void bindEnums(py::module_& module)
{
    py::enum_<BrushKind> kinds(module, "BrushKind", "What a brush does.");
    for (const BrushKind kind : shownBrushes()) {
        if (const char* name = brushType(kind).info.scriptKind; *name != '\0') {
            kinds.value(name, kind);
        }
    }
    bindChoices<BrushSelection>(module, "Selection", "Screen area to individuals or points.",
                                kSelections);
    bindChoices<BrushOperator>(module, "Operator", "How values vary over what is selected.",
                               kOperatorChoices);
    bindChoices<HeadingMode>(module, "Facing", "Which way: a direction, or after something.",
                             kHeadingModes);
    bindChoices<TimeMode>(module, "Timing", "How the delays of people go over them.", kTimeModes);
    bindChoices<PushMode>(module, "Movement", "How people are moved.", kPushModes);
}

/// Classes of the settings that scripts may set.
template<class Settings>
void bindSettings(py::module_& module, const BrushType& brush)
{
    const BrushInfo& info = brush.info;
    if (*info.scriptClass != '\0') {
        bindStruct<PythonSettings<Settings>, Settings>(module, info.scriptClass, info.doc,
                                                       brush.fields);
    }
}

/// An attribute for each section, and for what kinds without one are set to.
template<class Settings>
void bindSection(BrushClass& type)
{
    const BrushInfo& info = Settings::kInfo;
    using Part = PythonSettings<Settings>;
    if (*info.scriptName != '\0') {
        bindPart(type, {info.scriptName, "", typeid(Part),
                        [](const py::handle& self) -> void* {
                            return &self.cast<PythonBrush&>().part<Settings>();
                        },
                        [](void* to, const void* from) {
                            *static_cast<Part*>(to) = *static_cast<const Part*>(from);
                        }});
    }
}

void bindShared(BrushClass& type)
{
    for (const BrushType& each : brushTypes()) {
        if (*each.info.scriptKind == '\0' || *each.info.scriptName != '\0') {
            continue;
        }
        for (const FieldInfo& field : each.fields) {
            if (!py::hasattr(type, field.meta.key)) {
                bindField(type, field, [key = field.meta.key](const py::handle& self) {
                    const FieldInfo* found = nullptr;
                    return sharedAttribute(self.cast<PythonBrush&>(), key, found);
                });
            }
        }
    }
}

PythonBrush brushOf(BrushKind kind)
{
    PythonBrush brush;
    brush.kind = kind;
    return brush;
}

py::dict asDict(const PythonBrush& brush)
{
    if (!brush.isKnownKind()) {
        throw ScriptError("brush.kind is none of the choices there are.");
    }
    return callPython(py::module_::import("json").attr("loads"),
                      py::make_tuple(brushJson(brush.settings()).dump()));
}

PythonBrush fromDict(const py::dict& settings)
{
    std::string text;
    try {
        text = callPython(py::module_::import("json").attr("dumps"), py::make_tuple(settings))
                   .cast<std::string>();
    } catch (py::error_already_set& problem) {
        if (problem.matches(PyExc_TypeError) || problem.matches(PyExc_ValueError)) {
            throw ScriptError(
                "The brush holds what JSON cannot: " + std::string(py::str(problem.value())) + ".");
        }
        throw;
    }
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_discarded()) {
        throw ScriptError("The brush holds what JSON cannot: nan or inf.");
    }
    return PythonBrush::of(valueOrRaise(brushFromJson(json)));
}

BrushClass bindBrush(py::module_& module)
{
    BrushClass type(module, "Brush", "A brush with the editor's own settings.");
    type.def(py::init(&brushOf), py::arg("kind"))
        .def(
            "copy", [](const PythonBrush& brush) { return PythonBrush(brush); },
            "Another one, set the same.")
        .def("to_dict", &asDict,
             "The settings of its kind as a dict that JSON can hold: what presets are kept as.")
        .def_static("from_dict", &fromDict, py::arg("settings"),
                    "The brush of such a dict; what is not in it is as the editor begins. Raises "
                    "Error where a member is wrong or unknown.")
        .def(
            "__eq__", [](const PythonBrush& a, const PythonBrush& b) { return a == b; },
            py::is_operator())
        .def("__copy__", [](const PythonBrush& brush) { return PythonBrush(brush); })
        .def("__deepcopy__",
             [](const PythonBrush& brush, const py::dict& /*made*/) { return PythonBrush(brush); })
        .def(py::pickle(&asDict, &fromDict)) // whose the templates are is known here alone
        .def_readwrite("kind", &PythonBrush::kind);
    bindFields(type, fieldsOf<BrushSettings>(),
               [](const py::handle& self) -> void* { return &self.cast<PythonBrush&>().area; });
    return type;
}

} // namespace

void bindBrushes(py::module_& module)
{
    module.attr("NEAREST_PATH") = kNearestPath;
    bindEnums(module);
    bindStruct<HeadingSettings, HeadingSettings>(
        module, "HeadingSettings", "Which way people face. Radians.", fieldsOf<HeadingSettings>());
    bindStruct<SeatGridSettings, SeatGridSettings>(
        module, "SeatGridSettings", "Which seats people come onto.", fieldsOf<SeatGridSettings>());
    bindStruct<MaskSettings, MaskSettings>(
        module, "MaskSettings", "On whom a brush may work at all.", fieldsOf<MaskSettings>());
#define CROWD_BIND_SETTINGS(name, settings)                                                        \
    bindSettings<settings>(module, brushType(BrushKind::name));
    CROWD_BRUSHES(CROWD_BIND_SETTINGS)
#undef CROWD_BIND_SETTINGS
    BrushClass type = bindBrush(module);
#define CROWD_BIND_SECTION(name, settings) bindSection<settings>(type);
    CROWD_BRUSHES(CROWD_BIND_SECTION)
#undef CROWD_BIND_SECTION
    bindShared(type);
}

} // namespace crowd::app
