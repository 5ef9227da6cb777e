// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "app/window/WindowAction.h"

namespace crowd::app {

/// Actions of the timeline: record into it, marks at the moment that is shown, from mark to mark.
[[nodiscard]] std::span<const WindowAction> timelineActions();

} // namespace crowd::app
