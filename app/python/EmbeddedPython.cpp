// SPDX-License-Identifier: MIT
#include "app/python/EmbeddedPython.h"

#include "app/python/PythonModule.h"

PYBIND11_EMBEDDED_MODULE(crowdbrush, module)
{
    crowd::app::registerModule(module);
}

namespace crowd::app {

namespace py = pybind11;

namespace {

constexpr int kFailed = 1;

/// Text is UTF-8 whatever the locale says, as scenes and their names are.
void useUtf8()
{
    PyPreConfig config;
    PyPreConfig_InitPythonConfig(&config);
    config.utf8_mode = 1;
    Py_PreInitialize(&config);
}

} // namespace

struct EmbeddedPython::Private
{
    explicit Private(bool handlesSignals) : interpreter(handlesSignals, 0, nullptr, false) {}

    py::scoped_interpreter interpreter;
};

EmbeddedPython::EmbeddedPython(bool handlesSignals)
{
    useUtf8();
    m_private = std::make_unique<Private>(handlesSignals);
}

EmbeddedPython::~EmbeddedPython() = default;

int exitStatus(const py::object& code)
{
    if (code.is_none()) {
        return 0;
    }
    if (py::isinstance<py::int_>(code)) {
        const auto status = static_cast<int>(PyLong_AsLong(code.ptr())); // -1 of what is too large
        PyErr_Clear();
        return status & 0xFF;
    }
    py::print(code, py::arg("file") = py::module_::import("sys").attr("stderr"));
    return kFailed;
}

} // namespace crowd::app
