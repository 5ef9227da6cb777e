// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>

#include "app/python/Binding.h"
#include "model/describe/Field.h"

/// Described values as attributes of Python classes, one function for each type of value rather
/// than for each member.
namespace crowd::app {

/// From the Python object to the described struct in it; raises where it is another object.
using StructOf = std::function<void*(const py::handle&)>;

/// Makes an attribute of a class from a field that is no struct. The editor's own enumerations need
/// bindChoices() before; members of others are texts, their choices' keys.
void bindField(py::object& type, const model::FieldInfo& field, const StructOf& structOf);

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

/// The class of a described struct with all its attributes; structs inside are references into it.
template<class Owner, class Struct>
py::class_<Owner> bindStruct(py::module_& module, const char* name, const char* doc)
{
    py::class_<Owner> type(module, name, doc);
    const StructOf structOf = [](const py::handle& self) -> void* {
        return static_cast<Struct*>(&self.cast<Owner&>());
    };
    const auto bindOne = [&](const auto& described, const model::FieldInfo& field) {
        if constexpr (requires { described.member; }) { // else it is computed: for forms alone
            using Member =
                std::remove_cvref_t<decltype(std::declval<Struct&>().*(described.member))>;
            if constexpr (model::Described<Member>) {
                const auto member = described.member;
                type.def_property(
                    field.meta.key,
                    py::cpp_function([member](Owner& self) -> Member& { return self.*member; },
                                     py::return_value_policy::reference_internal),
                    [member](Owner& self, const Member& value) { self.*member = value; });
            } else {
                bindField(type, field, structOf);
            }
        }
    };
    const auto infos = model::fieldsOf<Struct>();
    std::size_t i = 0;
    std::apply([&](const auto&... each) { (bindOne(each, infos[i++]), ...); }, Struct::fields());
    return type;
}

} // namespace crowd::app
