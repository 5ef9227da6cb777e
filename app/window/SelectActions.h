// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "app/window/WindowAction.h"

namespace crowd::app {

/// Who is selected, and what the selected are gathered to.
[[nodiscard]] std::span<const WindowAction> selectActions();

} // namespace crowd::app
