// SPDX-License-Identifier: MIT
#pragma once

#include "app/window/MainWindow.h"
#include "app/window/WindowAction.h"

namespace crowd::app {

/// The action that turns one of the view's options on and off, and shows how it stands.
template<bool widgets::ViewOptions::*Option>
WindowAction viewSwitch(const widgets::ActionSpec& spec)
{
    return {spec,
            [](MainWindow& window, bool isOn) {
                auto options = window.state().viewOptions();
                options.*Option = isOn;
                window.state().setViewOptions(options);
            },
            {.inputs = widgets::ActionInput::View,
             .isChecked = [](MainWindow& window) { return window.state().viewOptions().*Option; }}};
}

} // namespace crowd::app
