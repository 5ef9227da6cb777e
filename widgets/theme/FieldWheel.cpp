// SPDX-License-Identifier: MIT
#include "widgets/theme/FieldWheel.h"

#include <QtCore/QEvent>
#include <QtWidgets/QAbstractSpinBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QSlider>

namespace crowd::widgets {

namespace {

bool isField(const QWidget& widget)
{
    return qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QSlider*>(&widget) != nullptr;
}

} // namespace

void FieldWheel::watch(QWidget& widget)
{
    if (!isField(widget)) {
        return;
    }
    if (widget.focusPolicy() == Qt::WheelFocus) {
        widget.setFocusPolicy(Qt::StrongFocus); // the wheel alone does not give it the keyboard
    }
    widget.installEventFilter(this);
}

void FieldWheel::forget(QWidget& widget)
{
    widget.removeEventFilter(this);
}

bool FieldWheel::eventFilter(QObject* watched, QEvent* event)
{
    const auto* field = qobject_cast<QWidget*>(watched);
    if (event->type() != QEvent::Wheel || field == nullptr) {
        return QObject::eventFilter(watched, event);
    }
    // A list keeps the keyboard after one has chosen from it: who scrolls on does not choose again.
    const bool isList = qobject_cast<const QComboBox*>(field) != nullptr;
    if (field->hasFocus() && !isList) {
        return QObject::eventFilter(watched, event);
    }
    event->ignore(); // so that it goes on to the parent
    return true;
}

} // namespace crowd::widgets
