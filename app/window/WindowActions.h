// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "widgets/actions/ActionRegistry.h"

namespace crowd::app {

class MainWindow;

/// Everything that menus, tool bars and keys of the window can do, put into its registry.
void addWindowActions(MainWindow& window);

/// All actions that the window has, with their keys as the settings have them, without what they
/// do: for who only tells of them.
void addActionsAlone(widgets::ActionRegistry& actions);

/// One menu: its title, to be translated in the context "Menus", and the ids of its actions; an
/// empty id is a separator, one that begins with @ a menu that the window fills.
struct MenuSpec
{
    const char* title;
    std::span<const char* const> ids;
};

[[nodiscard]] std::span<const MenuSpec> menuTable();
/// A menu in a menu: its title, to be translated in the context "Menus", and the ids of its
/// actions; none: the window fills it.
struct SubmenuSpec
{
    std::string_view id; ///< begins with @
    const char* title;
    std::span<const char* const> ids;
};
[[nodiscard]] const SubmenuSpec& submenuSpec(std::string_view id);
/// Ids on the tool bar; an empty id is a separator.
[[nodiscard]] std::span<const char* const> toolBarTable();

} // namespace crowd::app
