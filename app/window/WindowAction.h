// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "widgets/actions/ActionRegistry.h"

namespace crowd::app {

class MainWindow;

/// As ActionState, of a window that is still to come.
struct WindowState
{
    widgets::ActionInputs inputs;
    bool (*isEnabled)(MainWindow& window) = nullptr;
    bool (*isChecked)(MainWindow& window) = nullptr;
    QString (*text)(MainWindow& window) = nullptr;
};

/// An action of the window: what it is, what it does, what it depends on.
struct WindowAction
{
    widgets::ActionSpec spec;
    void (*run)(MainWindow& window, bool isChecked);
    WindowState state = {};
};

} // namespace crowd::app
