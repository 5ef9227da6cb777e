// SPDX-License-Identifier: MIT
#include "app/commands/ScriptCommand.h"

#include <cstdio>
#include <filesystem>

#include <pybind11/embed.h>

#include "app/python/PythonModule.h"

PYBIND11_EMBEDDED_MODULE(crowdbrush, module)
{
    crowd::app::registerModule(module);
}

namespace crowd::app {

namespace {

namespace py = pybind11;

constexpr int kFailed = 1;

/// What sys.exit(value) means: None is success, a number is the status, anything else is printed.
int statusOf(const py::object& code)
{
    if (code.is_none()) {
        return 0;
    }
    if (py::isinstance<py::int_>(code)) {
        return code.cast<int>() & 0xFF;
    }
    py::print(code, py::arg("file") = py::module_::import("sys").attr("stderr"));
    return kFailed;
}

/// Text is UTF-8 whatever the locale says, as scenes and their names are.
void useUtf8()
{
    PyPreConfig config;
    PyPreConfig_InitPythonConfig(&config);
    config.utf8_mode = 1;
    Py_PreInitialize(&config);
}

/// As python3 runs a file: as __main__, with its folder first on the path.
void runFile(const ScriptOptions& options)
{
    py::list arguments;
    arguments.append(options.file);
    for (const std::string& each : options.arguments) {
        arguments.append(each);
    }
    const py::module_ sys = py::module_::import("sys");
    sys.attr("argv") = arguments;
    const auto folder = std::filesystem::absolute(options.file).parent_path().string();
    sys.attr("path").attr("insert")(0, folder);
    py::module_::import("runpy").attr("run_path")(options.file, py::none(), "__main__");
}

} // namespace

int runScript(const ScriptOptions& options)
{
    if (!std::filesystem::is_regular_file(options.file)) {
        std::fprintf(stderr, "%s is not a file. Check the name and the folder.\n",
                     options.file.c_str());
        return kFailed;
    }
    useUtf8();
    const py::scoped_interpreter interpreter(true, 0, nullptr, false);
    int status = 0;
    try {
        runFile(options);
    } catch (py::error_already_set& problem) {
        if (problem.matches(PyExc_SystemExit)) {
            status = statusOf(problem.value().attr("code"));
        } else {
            problem.restore();
            PyErr_Print();
            status = kFailed;
        }
    }
    py::exec("import sys; sys.stdout.flush(); sys.stderr.flush()");
    return status;
}

} // namespace crowd::app
