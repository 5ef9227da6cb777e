// SPDX-License-Identifier: MIT
#include "app/commands/ScriptCommand.h"

#include <cstdio>
#include <filesystem>

#include "app/python/EmbeddedPython.h"

namespace crowd::app {

namespace {

namespace py = pybind11;

constexpr int kFailed = 1;

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

/// Whoever read the output may have gone.
void flush()
{
    try {
        py::exec("import sys; sys.stdout.flush(); sys.stderr.flush()");
    } catch (py::error_already_set&) {
        py::exec("import os, sys; sys.stdout = open(os.devnull, 'w')");
    }
}

} // namespace

int runScript(const ScriptOptions& options)
{
    if (!std::filesystem::is_regular_file(options.file)) {
        std::fprintf(stderr,
                     "crowdbrush script: %s is not a file. Check the name and the folder.\n",
                     options.file.c_str());
        return kFailed;
    }
    const EmbeddedPython python(true);
    int status = 0;
    try {
        runFile(options);
    } catch (py::error_already_set& problem) {
        if (problem.matches(PyExc_SystemExit)) {
            status = exitStatus(problem.value().attr("code"));
        } else {
            problem.restore();
            PyErr_Print();
            status = kFailed;
        }
    }
    flush();
    return status;
}

} // namespace crowd::app
