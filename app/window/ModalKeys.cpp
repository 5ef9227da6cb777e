// SPDX-License-Identifier: MIT
#include "app/window/ModalKeys.h"

#include <QtCore/QEvent>
#include <QtGui/QWindow>
#include <QtWidgets/QApplication>

namespace crowd::app {

namespace {

constexpr int kHandOverMs = 200; ///< longer than a window manager takes to hand over the keyboard

} // namespace

ModalKeys::ModalKeys(QWidget& window) : QObject(&window), m_window(window)
{
    m_look.setSingleShot(true);
    m_look.setInterval(kHandOverMs);
    connect(&m_look, &QTimer::timeout, this, [this] {
        if (QApplication::activeWindow() == &m_window) {
            claim();
        }
    });
    qApp->installEventFilter(this);
}

bool ModalKeys::isOfWindow(const QObject* receiver) const
{
    if (const auto* widget = qobject_cast<const QWidget*>(receiver)) {
        return widget->window() == &m_window;
    }
    return receiver == m_window.windowHandle();
}

void ModalKeys::claim()
{
    if (QWidget* dialog = QApplication::activeModalWidget();
        dialog != nullptr && dialog->isVisible()) {
        dialog->raise();
        dialog->activateWindow();
    }
}

bool ModalKeys::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::WindowBlocked && watched == &m_window) {
        m_look.start();
    }
    const bool isKey = event->type() == QEvent::ShortcutOverride ||
                       event->type() == QEvent::Shortcut || event->type() == QEvent::KeyPress;
    if (!isKey || QApplication::activeModalWidget() == nullptr || !isOfWindow(watched)) {
        return QObject::eventFilter(watched, event);
    }
    claim();
    event->accept(); // no shortcut either
    return true;
}

} // namespace crowd::app
