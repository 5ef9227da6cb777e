// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace crowd::app {

/// crowdbrush script FILE.py [ARGS …]: a script in the program's own interpreter, with the module
/// crowdbrush ready to import and the script's folder first on its path. Needs no display.
struct ScriptOptions
{
    std::string file;
    std::vector<std::string> arguments; ///< sys.argv[1:]
};

/// The exit code: what the script gave to sys.exit, 0 without; 1 with a trace on standard error
/// after an exception.
[[nodiscard]] int runScript(const ScriptOptions& options);

} // namespace crowd::app
