// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <typeindex>

#include "app/python/Binding.h"
#include "model/describe/Field.h"

/// Described values as attributes of Python classes, one function for each type of value rather
/// than for each member.
namespace crowd::app {

/// From the Python object to the described struct in it; raises where it is another object.
using StructOf = std::function<void*(const py::handle&)>;

/// Makes an attribute of a class from a field; one that is a struct is a reference into the object.
/// The editor's own enumerations need bindChoices() before, structs their class; members of other
/// enumerations are texts, their choices' keys.
void bindField(py::object& type, const model::FieldInfo& field, const StructOf& structOf);
/// Of all fields that are members: what is computed is for forms alone.
void bindFields(py::object& type, std::span<const model::FieldInfo> fields,
                const StructOf& structOf);

/// The signature of a constructor that takes fields by name, for the manual and the stubs.
[[nodiscard]] std::string signatureOf(const char* type, std::span<const model::FieldInfo> fields);
/// Sets attributes by name; raises for names that there are none of and values that a field may not
/// have.
void setFields(const py::object& self, const py::kwargs& given,
               std::span<const model::FieldInfo> fields);
/// Raises where a value is none that its field may have.
void needLegal(std::span<const model::FieldInfo> fields, const void* object);

/// An attribute that is a reference to something of a bound type inside the object. `assign` copies
/// from the second to the first.
struct __attribute__((visibility("hidden"))) PartInfo // as pybind11's own
{
    const char* name;
    const char* doc;
    std::type_index type;
    StructOf partOf;
    std::function<void(void*, const void*)> assign;
};
void bindPart(py::object& type, const PartInfo& part);

/// An enumeration of Python for the choices of a field.
template<class Enum>
py::enum_<Enum> bindChoices(py::module_& module, const char* name, const char* doc,
                            std::span<const model::FieldChoice> choices)
{
    py::enum_<Enum> type(module, name, doc);
    int number = 0;
    for (const model::FieldChoice& choice : choices) {
        type.value(choice.key, static_cast<Enum>(number++), choice.tip);
    }
    return type;
}

/// Weighted clips as the dict of name → weight that scripts see, and back.
[[nodiscard]] py::dict clipsAsDict(const std::vector<model::ClipWeight>& weights);
[[nodiscard]] std::vector<model::ClipWeight> clipsFromDict(const py::dict& clips);
/// Raises where it is no number from 0 on.
[[nodiscard]] float weightFrom(const py::handle& given);

/// The class of a described struct with all its attributes.
template<class Owner, class Struct>
py::class_<Owner> bindStruct(py::module_& module, const char* name, const char* doc,
                             std::span<const model::FieldInfo> fields)
{
    py::class_<Owner> type(module, name, doc);
    bindFields(type, fields, [](const py::handle& self) -> void* {
        return static_cast<Struct*>(&self.cast<Owner&>());
    });
    type.def("__copy__", [](const Owner& given) { return Owner(given); });
    type.def("__deepcopy__",
             [](const Owner& given, const py::dict& /*made*/) { return Owner(given); });
    return type;
}

/// The same, made with `Name(attribute=value, …)`. Owner can be copied.
template<class Owner>
py::class_<Owner> bindNamed(py::module_& module, const char* name, const char* doc,
                            std::span<const model::FieldInfo> fields)
{
    py::class_<Owner> type = bindStruct<Owner, Owner>(module, name, doc, fields);
    const std::string signature = signatureOf(name, fields);
    py::options options;
    options.disable_function_signatures();
    type.def(py::init([fields](const py::kwargs& given) {
                 const py::object made = py::cast(Owner());
                 setFields(made, given, fields);
                 needLegal(fields, &made.cast<const Owner&>());
                 return made.cast<Owner>();
             }),
             signature.c_str());
    return type;
}

} // namespace crowd::app
