// SPDX-License-Identifier: MIT
#include "app/console/ScriptGuard.h"

#include <QtGui/QKeyEvent>
#include <QtWidgets/QApplication>

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
        // Plain turning moves the view; with a modifier it changes the brush.
        return static_cast<const QInputEvent&>(event).modifiers() != Qt::NoModifier;
    default:
        return false;
    }
}

} // namespace

ScriptGuard::ScriptGuard(Interpreter& interpreter, widgets::EditorState& state, QWidget& window,
                         QWidget& console, QAction& stop)
    : QObject(&console), m_state(state), m_window(window), m_console(console), m_stop(stop)
{
    connect(&interpreter, &Interpreter::started, this, [this] { qApp->installEventFilter(this); });
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

bool ScriptGuard::isHeldBack(QObject* watched) const
{
    const auto* widget = qobject_cast<const QWidget*>(watched);
    if (widget == nullptr) {
        return qobject_cast<QAction*>(watched) != nullptr && watched != &m_stop;
    }
    if (qobject_cast<const widgets::WorkBar*>(widget->parentWidget()) != nullptr) {
        return false; // its button stops the work
    }
    const bool isOfWindow = widget == &m_window || m_window.isAncestorOf(widget);
    return isOfWindow && widget != &m_console && !m_console.isAncestorOf(widget);
}

bool ScriptGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (!isEditing(*event) || !isHeldBack(watched)) {
        return false;
    }
    if (takesBack(*event)) {
        return true;
    }
    m_state.showStatus(tr("A script is running: wait for it, or stop it in the console."));
    return true;
}

} // namespace crowd::app
