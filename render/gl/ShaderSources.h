// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace crowd::render {

/// Text of a file in resources/shaders, built into the program; empty if there is none.
[[nodiscard]] std::string_view shaderSource(std::string_view name);

} // namespace crowd::render
