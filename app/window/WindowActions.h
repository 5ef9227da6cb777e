// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "widgets/actions/ActionRegistry.h"

namespace crowd::app {

class MainWindow;

/// Everything that menus, tool bars and keys of the window can do, put into its registry.
void addWindowActions(MainWindow& window);

/// One menu: its title, to be translated in the context "Menus", and the ids of its actions; an
/// empty id is a separator.
struct MenuSpec
{
    const char* title;
    std::span<const char* const> ids;
};

[[nodiscard]] std::span<const MenuSpec> menuTable();
/// Ids on the tool bar; an empty id is a separator.
[[nodiscard]] std::span<const char* const> toolBarTable();

} // namespace crowd::app
