// SPDX-License-Identifier: MIT
#include <cstring>

#include <pybind11/eval.h>

#include "BrushesSource.h"
#include "app/python/Binding.h"
#include "app/python/OutsidePython.h"

namespace crowd::app {

namespace {

using Record = py::detail::function_record;

/// What pybind11 keeps of a function of ours; null: it is not one.
Record* recordOf(const py::handle& function)
{
    const py::handle bare = py::detail::get_function(function);
    if (!bare || PyCFunction_Check(bare.ptr()) == 0) {
        return nullptr;
    }
    PyObject* self = PyCFunction_GET_SELF(bare.ptr());
    const char* name = py::detail::get_function_record_capsule_name();
    return self != nullptr && PyCapsule_IsValid(self, name) != 0
               ? static_cast<Record*>(PyCapsule_GetPointer(self, name))
               : nullptr;
}

/// The module's names, for as long as there is Python.
PyObject* explanations = nullptr;

/// As pybind11 made it; the same for all functions.
PyCFunctionWithKeywords plainCall = nullptr;

std::string nameOf(const Record& record)
{
    std::string name = record.name;
    if (!record.scope || !py::hasattr(record.scope, "__qualname__")) {
        return name;
    }
    const auto owner = record.scope.attr("__qualname__").cast<std::string>();
    return name == "__init__" ? owner : owner + "." + name;
}

bool contains(const py::handle& message, const char* part)
{
    const auto text = py::str(message).cast<std::string>();
    return text.find(part) != std::string::npos;
}

/// The sentence in the place of the exception that waits.
void sayInstead(const char* function, const py::tuple& arguments)
{
    const py::object said = py::handle(explanations)[function](*arguments);
    PyErr_SetObject(PyExc_TypeError, said.ptr());
}

/// Turns what pybind11 raised about the C++ behind a call into a sentence about its arguments.
void explain(const Record& record, const py::tuple& args, const py::dict& kwargs)
{
    py::error_already_set problem; // takes it away
    const bool isCall = problem.matches(PyExc_TypeError) &&
                        (contains(problem.value(), "(): incompatible ") ||
                         contains(problem.value(), "invalid or missing `self`"));
    const bool isValue =
        problem.type().ptr() == PyExc_RuntimeError && contains(problem.value(), "Unable to cast");
    if (!isCall && !isValue) {
        problem.restore();
        return;
    }
    const std::string name = nameOf(record);
    if (isValue) {
        sayInstead("_explain_value", py::make_tuple(name, args, kwargs));
    } else {
        sayInstead("_explain_call", py::make_tuple(name, record.signature, args, kwargs));
    }
}

PyObject* speakingCall(PyObject* self, PyObject* args, PyObject* kwargs)
{
    const InsideModule call;
    PyObject* result = plainCall(self, args, kwargs);
    const bool isOdd = result == nullptr && (PyErr_ExceptionMatches(PyExc_TypeError) != 0 ||
                                             PyErr_ExceptionMatches(PyExc_RuntimeError) != 0);
    if (!isOdd) {
        return result;
    }
    try {
        const char* name = py::detail::get_function_record_capsule_name();
        explain(*static_cast<const Record*>(PyCapsule_GetPointer(self, name)),
                py::reinterpret_borrow<py::tuple>(args),
                kwargs == nullptr ? py::dict() : py::reinterpret_borrow<py::dict>(kwargs));
    } catch (py::error_already_set& problem) {
        problem.restore();
    }
    return nullptr;
}

void teach(const py::handle& function, const std::string& name = {})
{
    Record* record = recordOf(function);
    if (record == nullptr || record->def == nullptr) {
        return;
    }
    const auto call = reinterpret_cast<PyCFunctionWithKeywords>(
        reinterpret_cast<void (*)()>(record->def->ml_meth));
    if (call == &speakingCall) {
        return;
    }
    plainCall = call;
    record->def->ml_meth =
        reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(&speakingCall));
    if (!name.empty() && (record->name == nullptr || *record->name == '\0')) {
        std::free(record->name); // its own, as pybind11 frees it in the end
        record->name = strdup(name.c_str());
        record->def->ml_name = record->name;
    }
}

void teachClass(const py::handle& type)
{
    const py::dict members(type.attr("__dict__"));
    const py::handle property(reinterpret_cast<PyObject*>(&PyProperty_Type));
    for (const auto& [name, member] : members) {
        if (py::isinstance(member, property)) {
            const auto key = name.cast<std::string>();
            teach(member.attr("fget"), key);
            teach(member.attr("fset"), key + " =");
        } else if (Py_IS_TYPE(member.ptr(), &PyStaticMethod_Type)) {
            teach(member.attr("__func__"));
        } else {
            teach(member);
        }
    }
}

} // namespace

void refuseUnmade(const py::handle& given)
{
    const auto* base = reinterpret_cast<PyTypeObject*>(py::detail::get_internals().instance_base);
    if (!given || PyObject_TypeCheck(given.ptr(), const_cast<PyTypeObject*>(base)) == 0) {
        return;
    }
    auto* instance = reinterpret_cast<py::detail::instance*>(given.ptr());
    for (const auto& part : py::detail::values_and_holders(instance)) {
        if (part.value_ptr() == nullptr) {
            const std::string name = Py_TYPE(given.ptr())->tp_name;
            std::string message = "This " + name;
            message.append(" was never made: call ").append(name);
            message.append("(...), not __new__ alone; a class of your own calls "
                           "super().__init__(...) first.");
            throw py::type_error(message);
        }
    }
}

void speakOfArguments(py::module_& module)
{
    py::exec(kArgumentsSource, module.attr("__dict__"));
    const py::dict members(module.attr("__dict__"));
    explanations = members.inc_ref().ptr();
    for (const auto& [name, member] : members) {
        if (PyType_Check(member.ptr()) != 0 && py::hasattr(member, "__module__") &&
            py::str(member.attr("__module__")).equal(module.attr("__name__"))) {
            teachClass(member);
        } else {
            teach(member);
        }
    }
}

} // namespace crowd::app
