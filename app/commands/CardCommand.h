// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace crowd::app {

struct CardOptions
{
    std::string output; ///< a .pdf file
};

/// Writes the quick reference card, with the keys as the preferences have them. Exit status.
[[nodiscard]] int runCard(const CardOptions& options, const std::string& language);

} // namespace crowd::app
