// SPDX-License-Identifier: MIT
#include "app/python/Binding.h"
#include "app/python/ColumnArrays.h"

namespace crowd::app {

using namespace model;

namespace {

const char* nameOf(PropertyKind kind)
{
    switch (kind) {
    case PropertyKind::Number:
        return "number";
    case PropertyKind::Angle:
        return "angle";
    case PropertyKind::Colour:
        return "colour";
    case PropertyKind::Choice:
        return "choice";
    case PropertyKind::Set:
        return "set";
    case PropertyKind::Reference:
        break;
    }
    return "reference";
}

const char* nameOf(PropertyBlend blend)
{
    switch (blend) {
    case PropertyBlend::Step:
        return "step";
    case PropertyBlend::Linear:
        return "linear";
    case PropertyBlend::Turn:
        return "turn";
    case PropertyBlend::Cycle:
        return "cycle";
    case PropertyBlend::Colour:
        break;
    }
    return "colour";
}

std::vector<std::string> writersOf(const PropertyInfo& property)
{
    constexpr std::array<std::pair<PropertyWriter, const char*>, 5> kNames{
        {{kWrittenByBrush, "brush"},
         {kWrittenByPanel, "panel"},
         {kWrittenByScript, "script"},
         {kWrittenByRule, "rule"},
         {kWrittenBySession, "session"}}};
    std::vector<std::string> names;
    for (const auto& [writer, name] : kNames) {
        if (property.isWrittenBy(writer)) {
            names.emplace_back(name);
        }
    }
    return names;
}

/// An end of the legal range, of properties that have one.
std::optional<double> limitOf(const PropertyInfo& property, double limit)
{
    return floatsPerValue(property.column.type) > 0 ? std::optional(limit) : std::nullopt;
}

} // namespace

void bindProperties(py::module_& module)
{
    using Info = const PropertyInfo&;
    py::class_<PropertyInfo>(module, "Property", "What there is to know of a column.")
        .def_property_readonly(
            "name", [](Info p) { return std::string(p.column.name); }, "As Scene.column takes it.")
        .def_property_readonly(
            "type", [](Info p) { return valueTypeText(p.column.type); }, "Of a value in NumPy.")
        .def_property_readonly(
            "low", [](Info p) { return limitOf(p, p.meta.low); },
            "The lowest legal number; None: any of its type.")
        .def_property_readonly(
            "high", [](Info p) { return limitOf(p, p.meta.high); },
            "The highest legal number; None: any of its type.")
        .def_property_readonly("default", &initialValue,
                               "Of those who are created without it, where neither template nor "
                               "seat suggest another: a number or a list of them.")
        .def_property_readonly(
            "kind", [](Info p) { return nameOf(p.traits.kind); },
            "number, angle, colour, choice, set or reference.")
        .def_property_readonly(
            "blend", [](Info p) { return nameOf(p.traits.blend); },
            "What lies between two values: step, linear, turn, cycle or colour.")
        .def_property_readonly("writers", &writersOf,
                               "Who may write it: brush, panel, script, rule, session.")
        .def_property_readonly(
            "doc", [](Info p) { return p.meta.doc; }, "What it is.");
    module.def(
        "properties",
        [] {
            std::vector<const PropertyInfo*> all;
            for (const PropertyInfo& property : properties()) {
                all.push_back(&property);
            }
            return all;
        },
        py::return_value_policy::reference,
        "All properties that individuals have, in the order of their columns.");
}

} // namespace crowd::app
