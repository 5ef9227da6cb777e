// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

class QDockWidget;
class QMenu;
class QMenuBar;
class QToolBar;
class QWidget;

namespace crowd::widgets {
class ActionRegistry;
class EditorState;
} // namespace crowd::widgets

/// The menu bar and the tool bar, from their tables.
namespace crowd::app {

/// Menus in menus by their id, "@recent"; what is in those without actions is for others to say. Of
/// two entries of a menu with the same mnemonic the later one gets a free letter.
using Submenus = std::map<std::string, QMenu*>;
[[nodiscard]] Submenus fillMenuBar(QMenuBar& bar, const widgets::ActionRegistry& actions,
                                   const std::vector<QDockWidget*>& docks);
/// With the field for the speed of play, which gives the keyboard back to the picture.
void fillToolBar(QToolBar& bar, const widgets::ActionRegistry& actions, widgets::EditorState& state,
                 QWidget& picture);

} // namespace crowd::app
