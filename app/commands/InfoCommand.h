// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace crowd::app {

/// crowdbrush info FILE [--json] [--as template|stage]
struct InfoOptions
{
    std::string file; ///< UTF-8
    bool json = false;
    std::string as; ///< "template", "stage" or empty: by what is in the file
};

/// Says on standard output what is in a scene, a template or a stage and what is wrong with it.
/// The exit status: 0, or 1 with one line on standard error. Needs no display.
[[nodiscard]] int runInfo(const InfoOptions& options);

} // namespace crowd::app
