// SPDX-License-Identifier: MIT
#include "app/console/ScriptGuard.h"

#include <QtGui/QKeyEvent>
#include <QtWidgets/QAbstractSpinBox>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QSlider>

#include "widgets/tools/ScriptPainter.h"
#include "widgets/viewport/WorkBar.h"

namespace crowd::app {

namespace {

bool isEditing(const QEvent& event)
{
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::TabletPress:
    case QEvent::TouchBegin:
    case QEvent::KeyPress:
    case QEvent::Shortcut:
    case QEvent::ContextMenu:
    case QEvent::DragEnter:
    case QEvent::Drop:
        return true;
    case QEvent::Wheel:
        return true;
    default:
        return false;
    }
}

/// Plain turning moves the view and scrolls; with a modifier it changes the brush, and in a field
/// its value.
bool isHarmlessTurn(const QWidget& widget, const QEvent& event)
{
    return event.type() == QEvent::Wheel &&
           static_cast<const QInputEvent&>(event).modifiers() == Qt::NoModifier &&
           qobject_cast<const QComboBox*>(&widget) == nullptr &&
           qobject_cast<const QAbstractSpinBox*>(&widget) == nullptr &&
           qobject_cast<const QSlider*>(&widget) == nullptr;
}

/// Of what hangs on the window: its panels, also those that float, and its menus. Dialogs are not:
/// whoever is asked must be able to answer.
bool hangsOn(const QWidget& window, const QWidget* widget)
{
    while (widget != nullptr && widget != &window) {
        if (qobject_cast<const QDialog*>(widget) != nullptr) {
            return false;
        }
        widget = widget->parentWidget();
    }
    return widget != nullptr;
}

/// What was open before is not there to be chosen from.
void closePopups()
{
    while (QWidget* popup = QApplication::activePopupWidget()) {
        if (!popup->close()) {
            return;
        }
    }
}

} // namespace

ScriptGuard::ScriptGuard(Interpreter& interpreter, widgets::EditorState& state, QWidget& window,
                         QWidget& console, QAction& stop)
    : QObject(&console), m_state(state), m_window(window), m_console(console), m_stop(stop)
{
    connect(&interpreter, &Interpreter::started, this, [this] {
        closePopups();
        qApp->installEventFilter(this);
    });
    connect(&interpreter, &Interpreter::finished, this, [this] { qApp->removeEventFilter(this); });
}

/// Escape takes back the stroke of a script brush, also after the button was let go.
bool ScriptGuard::takesBack(const QEvent& event) const
{
    widgets::ScriptPainter* painter = m_state.scriptPainter();
    const bool isEscape = event.type() == QEvent::KeyPress &&
                          static_cast<const QKeyEvent&>(event).key() == Qt::Key_Escape;
    if (!isEscape || painter == nullptr || !painter->isPainting()) {
        return false;
    }
    painter->cancel();
    return true;
}

bool ScriptGuard::isHeldBack(QObject* watched, const QEvent& event) const
{
    const auto* widget = qobject_cast<const QWidget*>(watched);
    if (widget == nullptr) {
        return event.type() == QEvent::Shortcut && watched != &m_stop;
    }
    if (qobject_cast<const widgets::WorkBar*>(widget->parentWidget()) != nullptr) {
        return false; // its button stops the work
    }
    return hangsOn(m_window, widget) && !hangsOn(m_console, widget) &&
           !isHarmlessTurn(*widget, event);
}

bool ScriptGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (!isEditing(*event) || !isHeldBack(watched, *event)) {
        return false;
    }
    if (takesBack(*event)) {
        return true;
    }
    m_state.showStatus(tr("A script is running: wait for it, or stop it in the console."));
    return true;
}

} // namespace crowd::app
