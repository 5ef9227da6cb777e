// SPDX-License-Identifier: MIT
#include "widgets/viewport/ViewportInput.h"

#include <algorithm>
#include <utility>

#include <QtGui/QCursor>
#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QTabletEvent>
#include <QtGui/QWheelEvent>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>

#include "widgets/tools/ToolKeys.h"

namespace crowd::widgets {

namespace {

constexpr int kPenWaitMs = 40;     ///< samples come faster, unless the pen rests
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

ViewportInput::ViewportInput(QWidget& picture, ToolController& tools)
    : m_picture(picture), m_tools(tools)
{
    m_sinceInput.start();
    m_penWait.setSingleShot(true);
    m_penWait.setInterval(kPenWaitMs);
    connect(&m_penWait, &QTimer::timeout, this, [this] { beginPenStroke(0.0); });
    QApplication::instance()->installEventFilter(this);
}

ToolInput ViewportInput::inputOf(const QSinglePointEvent& event, double pressure)
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

ToolInput ViewportInput::resting() const
{
    ToolInput input = m_lastInput;
    input.button = Qt::NoButton;
    input.pointer.timeSeconds += static_cast<double>(m_sinceInput.nsecsElapsed()) * 1e-9;
    input.pointer.shownSeconds = m_shownSeconds;
    return input;
}

bool ViewportInput::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_picture) {
        return takeEvent(*event);
    }
    const bool isKey =
        event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    return isKey && (takeFromList(*watched, *static_cast<QKeyEvent*>(event)) ||
                     playFromPanel(*watched, *static_cast<QKeyEvent*>(event)));
}

bool ViewportInput::takeEvent(QEvent& event)
{
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: { // quick dabs are dabs
        ToolInput input = inputOf(static_cast<QMouseEvent&>(event), 1.0);
        input.isSecond = event.type() == QEvent::MouseButtonDblClick;
        m_tools.press(input);
        return true;
    }
    case QEvent::MouseMove:
        move(static_cast<QMouseEvent&>(event));
        return true;
    case QEvent::MouseButtonRelease:
        m_tools.release(inputOf(static_cast<QMouseEvent&>(event), 1.0));
        return true;
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
        takeTablet(static_cast<QTabletEvent&>(event));
        return true;
    case QEvent::Wheel:
        turnWheel(static_cast<QWheelEvent&>(event));
        return true;
    case QEvent::ShortcutOverride:
        return claimKey(static_cast<QKeyEvent&>(event));
    case QEvent::KeyPress:
        return pressKey(static_cast<QKeyEvent&>(event));
    case QEvent::KeyRelease:
        return m_tools.keyUp(keyOf(static_cast<QKeyEvent&>(event)));
    case QEvent::Enter:
        takeKeys();
        return false;
    case QEvent::Leave:
        m_tools.leave();
        return false;
    case QEvent::FocusOut:
        m_tools.loseKeys();
        return false;
    default:
        return false;
    }
}

void ViewportInput::move(const QSinglePointEvent& event)
{
    const ToolInput input = inputOf(event, 1.0);
    takeKeys();
    m_tools.move(input);
    if (m_tools.isHandsFree()) {
        keepPointerInside(input);
    }
}

void ViewportInput::takeTablet(QTabletEvent& event)
{
    event.accept(); // else the same movement comes again as a mouse event
    const ToolInput input = inputOf(event, event.pressure());
    switch (event.type()) {
    case QEvent::TabletPress:
        m_picture.setFocus(Qt::MouseFocusReason);
        m_penPress = input;
        m_penWait.start();
        break;
    case QEvent::TabletRelease:
        beginPenStroke(0.0);
        m_tools.release(input);
        break;
    default:
        beginPenStroke(event.pressure());
        m_tools.move(input);
        break;
    }
}

/// A pen begins with next to no pressure, whatever the hand means: the next sample counts, too.
void ViewportInput::beginPenStroke(double pressure)
{
    m_penWait.stop();
    if (auto press = std::exchange(m_penPress, std::nullopt)) {
        press->pointer.pressure = std::max(press->pointer.pressure, static_cast<float>(pressure));
        m_tools.press(*press);
    }
}

void ViewportInput::turnWheel(QWheelEvent& event)
{
    // Alt turns the wheel sideways on some systems.
    const QPoint angle = event.angleDelta();
    const int delta = angle.y() != 0 ? angle.y() : angle.x();
    m_tools.wheel({inputOf(event, 1.0), delta / kNotch});
    event.accept();
}

void ViewportInput::keepPointerInside(const ToolInput& input)
{
    const QRect inside =
        m_picture.rect().adjusted(kPointerMargin, kPointerMargin, -kPointerMargin, -kPointerMargin);
    if (inside.isEmpty() || inside.contains(input.position().toPoint())) {
        return;
    }
    ToolInput placed = input;
    placed.pointer.grid = model::gridPoint({m_picture.width() / 2.0, m_picture.height() / 2.0});
    QCursor::setPos(m_picture.mapToGlobal(
        QPointF(m_picture.width() / 2.0, m_picture.height() / 2.0).toPoint()));
    m_lastInput = placed;
    m_tools.pointerPlaced(placed);
}

/// What is claimed comes back as a key press instead of a shortcut.
bool ViewportInput::claimKey(QKeyEvent& event)
{
    if (!m_tools.claimsKey(event.key(), event.modifiers())) {
        return false;
    }
    event.accept();
    return true;
}

/// During a drag all keys are the tool's, also those that mean nothing to it.
bool ViewportInput::pressKey(const QKeyEvent& event)
{
    const bool isClaimed = m_tools.claimsKey(event.key(), event.modifiers());
    return m_tools.keyDown(keyOf(event)) || isClaimed;
}

/// Who has last clicked in a panel, beside a list of it or on a cue, plays with Space all the same;
/// only what is chosen and can be ticked by it stays the list's.
bool ViewportInput::playFromPanel(const QObject& watched, const QKeyEvent& event)
{
    const auto* list = qobject_cast<const QAbstractItemView*>(&watched);
    const bool isSpace = event.key() == Qt::Key_Space && event.modifiers() == Qt::NoModifier;
    if (!isSpace || list == nullptr || !list->hasFocus() ||
        qobject_cast<QDialog*>(list->window()) != nullptr ||
        QApplication::activePopupWidget() != nullptr) {
        return false;
    }
    const QModelIndex chosen = list->currentIndex();
    const bool isTicked = chosen.data(Qt::CheckStateRole).isValid();
    if (isTicked && list->selectionModel()->isSelected(chosen)) {
        return false;
    }
    if (event.type() == QEvent::KeyPress && !event.isAutoRepeat()) {
        m_tools.togglePlaying();
    }
    return event.type() == QEvent::KeyPress;
}

/// Keys that mean something to a list with the focus are the brush's while the pointer is over the
/// picture, even if it has not moved since the list was left.
bool ViewportInput::takeFromList(const QObject& watched, QKeyEvent& event)
{
    if (!isHandKey(event) || m_picture.hasFocus()) {
        return false;
    }
    const auto* list = qobject_cast<const QComboBox*>(&watched);
    const QPoint pointer = QCursor::pos();
    if (list == nullptr || !list->hasFocus() || QApplication::activePopupWidget() != nullptr ||
        !m_picture.rect().contains(m_picture.mapFromGlobal(pointer)) ||
        QApplication::widgetAt(pointer) != &m_picture) {
        return false;
    }
    takeKeys();
    return m_picture.hasFocus() && QApplication::sendEvent(&m_picture, &event);
}

/// Over the picture keys are the brush's, also after a choice from a list, which would keep `+` and
/// `-` to itself; only who types a text goes on typing.
void ViewportInput::takeKeys()
{
    const QWidget* focused = QApplication::focusWidget();
    if (focused != nullptr && focused != &m_picture && focused->window() == m_picture.window() &&
        !takesText(*focused)) {
        m_picture.setFocus(Qt::MouseFocusReason);
    }
}

} // namespace crowd::widgets
