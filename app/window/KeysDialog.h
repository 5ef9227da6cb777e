// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QDialog>

#include "widgets/actions/ActionRegistry.h"
#include "widgets/state/EditorState.h"

namespace crowd::app {

/// What mouse buttons and keys do: in the picture, and as shortcuts, as they are set now.
class KeysDialog : public QDialog
{
    Q_OBJECT

public:
    KeysDialog(const widgets::ActionRegistry& actions, widgets::ButtonMapping buttons,
               QWidget* parent);

private:
    [[nodiscard]] QWidget* picturePage(const widgets::ActionRegistry& actions,
                                       widgets::ButtonMapping buttons);
    [[nodiscard]] QWidget* shortcutPage(const widgets::ActionRegistry& actions);
};

} // namespace crowd::app
