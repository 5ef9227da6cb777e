// SPDX-License-Identifier: MIT
#include "app/window/FieldKeys.h"

#include <QtCore/QPointer>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QAbstractSpinBox>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLineEdit>

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
}

bool FieldKeys::isOfPanel(const QWidget& field) const
{
    for (const QWidget* each = &field; each != nullptr; each = each->parentWidget()) {
        if (qobject_cast<const QDockWidget*>(each) != nullptr) {
            return each->parentWidget() == &m_window;
        }
        if (qobject_cast<const QDialog*>(each) != nullptr) {
            return false;
        }
    }
    return false;
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

bool FieldKeys::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey =
        event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    auto* field = isKey ? qobject_cast<QWidget*>(watched) : nullptr;
    if (field == nullptr || !endsTyping(static_cast<QKeyEvent*>(event)->key()) ||
        !isTextField(*field) || !isOfPanel(*field)) {
        return QObject::eventFilter(watched, event);
    }
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept(); // comes back as a key press
        return true;
    }
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        takeBackTyping(*field);
    }
    // First the field takes what was typed; the editor of a list does so with the next event.
    const QPointer<QWidget> list = listOf(*field);
    const auto giveNext = [this, list] {
        QMetaObject::invokeMethod(
            this, [this, list] { giveBack(list); }, Qt::QueuedConnection);
    };
    QMetaObject::invokeMethod(this, giveNext, Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
}

} // namespace crowd::app
