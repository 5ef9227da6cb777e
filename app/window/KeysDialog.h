// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QDialog>

#include "widgets/actions/ActionRegistry.h"

namespace crowd::app {

/// What keys and mouse buttons do, on one page.
class KeysDialog : public QDialog
{
    Q_OBJECT

public:
    KeysDialog(const widgets::ActionRegistry& actions, QWidget* parent);
};

} // namespace crowd::app
