// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QObject>
#include <QtGui/QAction>
#include <QtWidgets/QWidget>

#include "app/console/Interpreter.h"

namespace crowd::app {

/// While a script runs, editing by hand waits: presses and keys in the window, its panels that
/// float and its menus are held back, except in the console, for what stops it and for turning the
/// wheel over the picture. Menus that are open when it begins are closed. The status bar says why.
/// Owned by the console.
class ScriptGuard : public QObject
{
    Q_OBJECT

public:
    ScriptGuard(Interpreter& interpreter, widgets::EditorState& state, QWidget& window,
                QWidget& console, QAction& stop);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool takesBack(const QEvent& event) const;
    [[nodiscard]] bool isHeldBack(QObject* watched, const QEvent& event) const;

    widgets::EditorState& m_state;
    QWidget& m_window;
    QWidget& m_console;
    QAction& m_stop;
};

} // namespace crowd::app
