// SPDX-License-Identifier: MIT
#include "app/console/ScriptGuard.h"

#include <QtGui/QInputEvent>
#include <QtWidgets/QApplication>

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
        // Plain turning moves the view; with a modifier it changes the brush.
        return static_cast<const QInputEvent&>(event).modifiers() != Qt::NoModifier;
    default:
        return false;
    }
}

} // namespace

ScriptGuard::ScriptGuard(Interpreter& interpreter, widgets::EditorState& state, QWidget& window,
                         QWidget& console, QAction& stop)
    : QObject(&window), m_state(state), m_window(window), m_console(console), m_stop(stop)
{
    connect(&interpreter, &Interpreter::started, this, [this] { qApp->installEventFilter(this); });
    connect(&interpreter, &Interpreter::finished, this, [this] { qApp->removeEventFilter(this); });
}

bool ScriptGuard::isHeldBack(QObject* watched) const
{
    const auto* widget = qobject_cast<const QWidget*>(watched);
    if (widget == nullptr) {
        return qobject_cast<QAction*>(watched) != nullptr && watched != &m_stop;
    }
    const bool isOfWindow = widget == &m_window || m_window.isAncestorOf(widget);
    return isOfWindow && widget != &m_console && !m_console.isAncestorOf(widget);
}

bool ScriptGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (!isEditing(*event) || !isHeldBack(watched)) {
        return false;
    }
    m_state.showStatus(tr("A script is running: wait for it, or stop it in the console."));
    return true;
}

} // namespace crowd::app
