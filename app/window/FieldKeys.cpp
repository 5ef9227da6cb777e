// SPDX-License-Identifier: MIT
#include "app/window/FieldKeys.h"

#include <QtGui/QKeyEvent>
#include <QtGui/QKeySequence>
#include <QtGui/QMouseEvent>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QAbstractSpinBox>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLineEdit>

#include "widgets/forms/RangeSlider.h"
#include "widgets/forms/ValueSlider.h"

namespace crowd::app {

namespace {

bool endsTyping(int key)
{
    return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Escape;
}

/// The keys of a list that one can type into go to the list itself.
bool isTextField(const QWidget& widget)
{
    const auto* list = qobject_cast<const QComboBox*>(&widget);
    return (list != nullptr && list->isEditable()) ||
           qobject_cast<const QLineEdit*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr;
}

/// Text fields, and sliders that one types into.
bool takesNumbers(const QWidget& widget)
{
    return isTextField(widget) || qobject_cast<const widgets::ValueSlider*>(&widget) != nullptr ||
           qobject_cast<const widgets::RangeSlider*>(&widget) != nullptr;
}

/// What a text field would take; not what saves, plays or takes back.
bool isTyping(const QKeyEvent& event)
{
    const bool isPlain =
        (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) == 0;
    const bool isRemoval = event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Delete;
    const bool isLetter = !event.text().isEmpty() && event.text().front().isPrint();
    return (isPlain && (isRemoval || isLetter)) || event.matches(QKeySequence::SelectAll) ||
           event.matches(QKeySequence::Copy) || event.matches(QKeySequence::Cut) ||
           event.matches(QKeySequence::Paste);
}

/// Whose entry is edited; null: a field by itself.
QWidget* listOf(const QWidget& field)
{
    QWidget* viewport = field.parentWidget();
    auto* list =
        viewport != nullptr ? qobject_cast<QAbstractItemView*>(viewport->parentWidget()) : nullptr;
    return list != nullptr && list->viewport() == viewport ? list : nullptr;
}

/// As it was when the typing began. The editor of a list does that by itself.
void takeBackTyping(QWidget& field)
{
    auto* list = qobject_cast<QComboBox*>(&field);
    auto* line = list != nullptr ? list->lineEdit() : qobject_cast<QLineEdit*>(&field);
    while (line != nullptr && line->isUndoAvailable()) {
        line->undo();
    }
}

} // namespace

FieldKeys::FieldKeys(QWidget& window, QWidget& picture)
    : QObject(&window), m_window(window), m_picture(picture)
{
    qApp->installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, &FieldKeys::follow);
}

QDockWidget* FieldKeys::panelOf(QWidget& field) const
{
    for (QWidget* each = &field; each != nullptr; each = each->parentWidget()) {
        if (auto* dock = qobject_cast<QDockWidget*>(each)) {
            return each->parentWidget() == &m_window ? dock : nullptr;
        }
        if (qobject_cast<const QDialog*>(each) != nullptr) {
            return nullptr;
        }
    }
    return nullptr;
}

void FieldKeys::giveBack(QWidget* list)
{
    if (list != nullptr) {
        list->setFocus(Qt::OtherFocusReason); // who renames goes on in the list
    } else if (QApplication::activeModalWidget() == nullptr &&
               QApplication::activePopupWidget() == nullptr) {
        m_window.activateWindow(); // the panel may float
        m_picture.setFocus(Qt::OtherFocusReason);
    }
}

void FieldKeys::notePress(QWidget& pressed, const QMouseEvent& event)
{
    const bool isSame =
        m_pressed != nullptr && event.timestamp() == m_pressTime && pressed.isAncestorOf(m_pressed);
    if (isSame) {
        return; // what is off hands the press on
    }
    m_pressed = &pressed;
    m_pressTime = event.timestamp();
    m_isAtOffField = !pressed.isEnabled() && takesNumbers(pressed) && panelOf(pressed) != nullptr;
}

void FieldKeys::follow(QWidget* before, QWidget* now)
{
    if (before != nullptr && isTextField(*before) && listOf(*before) == nullptr &&
        panelOf(*before) != nullptr) {
        takeFromHidden(*before);
    }
    QDockWidget* panel = now != nullptr && isTextField(*now) ? panelOf(*now) : nullptr;
    if (panel != nullptr) {
        connect(panel, &QDockWidget::visibilityChanged, this, &FieldKeys::noteSeen,
                Qt::UniqueConnection);
    }
}

/// Qt hands the keys on to whatever comes next, where no brush is chosen with them.
void FieldKeys::takeFromHidden(QWidget& before)
{
    const auto takeNow = [this, field = QPointer<QWidget>(&before)] {
        const QWidget* now = QApplication::focusWidget();
        const bool isChosen = now != nullptr && now == m_pressed && isTextField(*now);
        if (field != nullptr && !field->isVisible() && !isChosen) {
            giveBack(nullptr);
        }
    };
    QMetaObject::invokeMethod(this, takeNow, Qt::QueuedConnection);
}

/// A panel behind another tab keeps the keys, for all that Qt does.
void FieldKeys::noteSeen(bool isSeen)
{
    QWidget* field = QApplication::focusWidget();
    if (!isSeen && field != nullptr && isTextField(*field) && panelOf(*field) == sender()) {
        giveBack(nullptr);
    }
}

bool FieldKeys::endTyping(QWidget& field, QEvent& event)
{
    if (event.type() == QEvent::ShortcutOverride) {
        event.accept(); // comes back as a key press
        return true;
    }
    if (static_cast<QKeyEvent&>(event).key() == Qt::Key_Escape) {
        takeBackTyping(field);
    }
    // First the field takes what was typed; the editor of a list does so with the next event.
    const QPointer<QWidget> list = listOf(field);
    const auto giveNext = [this, list] {
        QMetaObject::invokeMethod(
            this, [this, list] { giveBack(list); }, Qt::QueuedConnection);
    };
    QMetaObject::invokeMethod(this, giveNext, Qt::QueuedConnection);
    return false;
}

/// Who types at a field means the field.
bool FieldKeys::passOver(QEvent& event)
{
    if (QApplication::activeModalWidget() != nullptr ||
        QApplication::activePopupWidget() != nullptr) {
        return false;
    }
    const auto& key = static_cast<const QKeyEvent&>(event);
    if (endsTyping(key.key())) {
        m_isAtOffField = false;
    }
    if (!m_isAtOffField || !isTyping(key)) {
        return false;
    }
    event.accept();
    if (event.type() == QEvent::KeyPress) {
        Q_EMIT typedAtNothing();
    }
    return true;
}

bool FieldKeys::eventFilter(QObject* watched, QEvent* event)
{
    auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr) {
        return QObject::eventFilter(watched, event);
    }
    if (event->type() == QEvent::MouseButtonPress) {
        notePress(*widget, *static_cast<QMouseEvent*>(event));
    }
    if (event->type() == QEvent::Enter && widget == &m_picture) {
        m_isAtOffField = false; // the hand has gone back to the picture
    }
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) {
        return QObject::eventFilter(watched, event);
    }
    if (m_isAtOffField && passOver(*event)) {
        return true;
    }
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (endsTyping(key) && isTextField(*widget) && panelOf(*widget) != nullptr &&
        endTyping(*widget, *event)) {
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace crowd::app
