// SPDX-License-Identifier: MIT
#include "app/python/PythonModule.h"

#include "app/python/Binding.h"
#include "app/python/OutsidePython.h"

namespace crowd::app {

namespace {

void needNumPy()
{
    try {
        py::module_::import("numpy");
    } catch (py::error_already_set&) {
        throw py::import_error("crowdbrush needs NumPy, which this Python does not have: install "
                               "the package python3-numpy, or run /usr/bin/python3.");
    }
}

/// What `from crowdbrush import *` brings: not open(), which is Python's own for whoever wrote
/// that.
void offerAll(py::module_& module)
{
    py::list names;
    const py::dict all = module.attr("__dict__");
    for (const auto& [name, value] : all) {
        const auto text = name.cast<std::string>();
        if (text.front() != '_' && text != "open" && !py::isinstance<py::module_>(value)) {
            names.append(name);
        }
    }
    names.attr("sort")();
    module.attr("__all__") = names;
}

} // namespace

void registerModule(py::module_& module)
{
    needNumPy();
    module.doc() = "Everything the editor can do to a crowd, scripted. Metres, seconds, radians; "
                   "Y is up and characters face +Z at heading 0. Columns are NumPy arrays.";
    py::register_exception<ScriptError>(module, "Error", PyExc_RuntimeError);
    bindTemplates(module);
    bindProperties(module);
    bindBrushes(module);
    bindPresets(module);
    bindScriptBrushes(module);
    bindScene(module);
    bindEntries(module);
    bindSession(module);
    speakOfArguments(module);
    offerAll(module);
    watchPythonsEnd();
}

} // namespace crowd::app
