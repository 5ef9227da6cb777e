// SPDX-License-Identifier: MIT
#include "widgets/viewport/ViewportWidget.h"

#include <algorithm>

#include <QtGui/QCursor>
#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QTabletEvent>
#include <QtGui/QWheelEvent>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>

#include "widgets/tools/ToolKeys.h"

/// The translation of the window system's events into tool input, and nothing else.
namespace crowd::widgets {

namespace {

constexpr double kNotch = 120.0;   ///< of QWheelEvent::angleDelta
constexpr int kPointerMargin = 40; ///< to the border while flying, logical pixels

double secondsOf(const QInputEvent& event)
{
    return static_cast<double>(event.timestamp()) * 1e-3;
}

std::uint8_t buttonsOf(Qt::MouseButtons buttons)
{
    int bits = 0;
    bits |= buttons.testFlag(Qt::LeftButton) ? model::LeftButton : 0;
    bits |= buttons.testFlag(Qt::RightButton) ? model::RightButton : 0;
    bits |= buttons.testFlag(Qt::MiddleButton) ? model::MiddleButton : 0;
    return static_cast<std::uint8_t>(bits);
}

std::uint8_t modifiersOf(Qt::KeyboardModifiers modifiers)
{
    int bits = 0;
    bits |= modifiers.testFlag(Qt::ShiftModifier) ? model::ShiftModifier : 0;
    bits |= modifiers.testFlag(Qt::ControlModifier) ? model::ControlModifier : 0;
    bits |= modifiers.testFlag(Qt::AltModifier) ? model::AltModifier : 0;
    return static_cast<std::uint8_t>(bits);
}

KeyInput keyOf(const QKeyEvent& event)
{
    return {event.key(), event.modifiers(), event.isAutoRepeat(), secondsOf(event)};
}

/// Of the hand that does not hold the mouse: play, look around, more and less.
bool isHandKey(const QKeyEvent& event)
{
    const KeyInput input = keyOf(event);
    return (input.key == Qt::Key_Space && input.modifiers == Qt::NoModifier) ||
           numberSteps(input) != 0;
}

/// A list of names is no text, though its names can be edited: then a field has the focus.
bool takesText(const QWidget& widget)
{
    return widget.testAttribute(Qt::WA_InputMethodEnabled) &&
           qobject_cast<const QAbstractItemView*>(&widget) == nullptr;
}

} // namespace

ToolInput ViewportWidget::inputOf(const QSinglePointEvent& event, double pressure)
{
    ToolInput input;
    const QPointF position = event.position();
    input.pointer =
        model::PointerInput::at({position.x(), position.y()}, secondsOf(event), m_shownSeconds);
    input.pointer.pressure = static_cast<float>(std::clamp(pressure, 0.0, 1.0));
    input.pointer.buttons = buttonsOf(event.buttons());
    input.pointer.modifiers = modifiersOf(event.modifiers());
    input.button = event.button();
    input.modifiers = event.modifiers();
    m_lastInput = input;
    m_sinceInput.start();
    return input;
}

ToolInput ViewportWidget::restingInput() const
{
    ToolInput input = m_lastInput;
    input.button = Qt::NoButton;
    input.pointer.timeSeconds += static_cast<double>(m_sinceInput.nsecsElapsed()) * 1e-9;
    input.pointer.shownSeconds = m_shownSeconds;
    return input;
}

void ViewportWidget::mousePressEvent(QMouseEvent* event)
{
    m_tools.press(inputOf(*event, 1.0));
}

void ViewportWidget::mouseDoubleClickEvent(QMouseEvent* event)
{
    mousePressEvent(event); // quick dabs are dabs
}

void ViewportWidget::mouseMoveEvent(QMouseEvent* event)
{
    const ToolInput input = inputOf(*event, 1.0);
    takeKeys();
    m_tools.move(input);
    if (m_tools.isHandsFree()) {
        keepPointerInside(input);
    }
}

void ViewportWidget::mouseReleaseEvent(QMouseEvent* event)
{
    m_tools.release(inputOf(*event, 1.0));
}

void ViewportWidget::tabletEvent(QTabletEvent* event)
{
    event->accept(); // else the same movement comes again as a mouse event
    const ToolInput input = inputOf(*event, event->pressure());
    switch (event->type()) {
    case QEvent::TabletPress:
        setFocus(Qt::MouseFocusReason);
        m_tools.press(input);
        break;
    case QEvent::TabletRelease:
        m_tools.release(input);
        break;
    default:
        m_tools.move(input);
        break;
    }
}

void ViewportWidget::wheelEvent(QWheelEvent* event)
{
    // Alt turns the wheel sideways on some systems.
    const QPoint angle = event->angleDelta();
    const int delta = angle.y() != 0 ? angle.y() : angle.x();
    m_tools.wheel({inputOf(*event, 1.0), delta / kNotch});
    event->accept();
}

void ViewportWidget::keepPointerInside(const ToolInput& input)
{
    const QRect inside =
        rect().adjusted(kPointerMargin, kPointerMargin, -kPointerMargin, -kPointerMargin);
    if (inside.isEmpty() || inside.contains(input.position().toPoint())) {
        return;
    }
    ToolInput placed = input;
    placed.pointer.grid = model::gridPoint({width() / 2.0, height() / 2.0});
    QCursor::setPos(mapToGlobal(QPointF(width() / 2.0, height() / 2.0).toPoint()));
    m_lastInput = placed;
    m_tools.pointerPlaced(placed);
}

bool ViewportWidget::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (m_tools.claimsKey(key.key(), key.modifiers())) {
            event->accept(); // comes back as a key press instead of a shortcut
            return true;
        }
    }
    return QOpenGLWidget::event(event);
}

void ViewportWidget::keyPressEvent(QKeyEvent* event)
{
    // During a drag all keys are the tool's, also those that mean nothing to it.
    const bool isClaimed = m_tools.claimsKey(event->key(), event->modifiers());
    if (!m_tools.keyDown(keyOf(*event)) && !isClaimed) {
        QOpenGLWidget::keyPressEvent(event);
    }
}

void ViewportWidget::keyReleaseEvent(QKeyEvent* event)
{
    if (!m_tools.keyUp(keyOf(*event))) {
        QOpenGLWidget::keyReleaseEvent(event);
    }
}

/// Keys that mean something to a list with the focus are the brush's while the pointer is over the
/// picture, even if it has not moved since the list was left.
bool ViewportWidget::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey =
        event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (!isKey || !isHandKey(*static_cast<QKeyEvent*>(event)) || hasFocus()) {
        return QOpenGLWidget::eventFilter(watched, event);
    }
    const auto* list = qobject_cast<QComboBox*>(watched);
    const QPoint pointer = QCursor::pos();
    if (list == nullptr || !list->hasFocus() || QApplication::activePopupWidget() != nullptr ||
        !rect().contains(mapFromGlobal(pointer)) || QApplication::widgetAt(pointer) != this) {
        return QOpenGLWidget::eventFilter(watched, event);
    }
    takeKeys();
    return hasFocus() && QApplication::sendEvent(this, event);
}

/// Over the picture keys are the brush's, also after a choice from a list, which would keep `+` and
/// `-` to itself; only who types a text goes on typing.
void ViewportWidget::takeKeys()
{
    const QWidget* focused = QApplication::focusWidget();
    if (focused != nullptr && focused != this && focused->window() == window() &&
        !takesText(*focused)) {
        setFocus(Qt::MouseFocusReason);
    }
}

void ViewportWidget::enterEvent(QEnterEvent* event)
{
    QOpenGLWidget::enterEvent(event);
    takeKeys();
}

void ViewportWidget::leaveEvent(QEvent* event)
{
    QOpenGLWidget::leaveEvent(event);
    m_tools.leave();
}

void ViewportWidget::focusOutEvent(QFocusEvent* event)
{
    QOpenGLWidget::focusOutEvent(event);
    m_tools.loseKeys();
}

} // namespace crowd::widgets
