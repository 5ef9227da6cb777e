// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "widgets/actions/Findable.h"

/// What the window can do, by name. Main thread only.
namespace crowd::app {

class MainWindow;

/// The panels, what the menus offer (those that are filled when they open, too), what has only
/// keys, and the settings that panels show now. Each runs as if it were chosen there; who keeps one
/// may do so until the menus are filled again.
[[nodiscard]] std::vector<widgets::Findable> findables(MainWindow& window);
/// Opens the dialog that finds them.
void findByName(MainWindow& window);

} // namespace crowd::app
