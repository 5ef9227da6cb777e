// SPDX-License-Identifier: MIT
#include "widgets/forms/FormRows.h"

#include <QtCore/QTimer>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QFrame>
#include <QtWidgets/QLabel>
#include <QtWidgets/QScrollArea>

#include "widgets/actions/MenuText.h"

namespace crowd::widgets {

namespace {

constexpr int kFlashMilliseconds = 1800;
constexpr int kSeenAround = 48; ///< logical pixels above and below what is scrolled to

} // namespace

QString nameOfRow(const QWidget& row)
{
    if (!row.accessibleName().isEmpty()) {
        return row.accessibleName();
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&row)) {
        return menuText(button->text());
    }
    const auto labels = row.findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly);
    for (const QLabel* label : labels) {
        if (label->buddy() != nullptr) {
            return menuText(label->text());
        }
    }
    return {};
}

QString tipOfRow(const QWidget& row)
{
    if (!row.toolTip().isEmpty()) {
        return row.toolTip();
    }
    const auto inside = row.findChildren<QWidget*>();
    for (const QWidget* widget : inside) {
        if (!widget->toolTip().isEmpty()) {
            return widget->toolTip();
        }
    }
    return {};
}

QWidget* controlOfRow(QWidget& row)
{
    if ((row.focusPolicy() & Qt::TabFocus) != 0) {
        return &row;
    }
    const auto inside = row.findChildren<QWidget*>();
    for (QWidget* widget : inside) {
        if ((widget->focusPolicy() & Qt::TabFocus) != 0 && widget->isEnabled()) {
            return widget;
        }
    }
    return nullptr;
}

void scrollTo(QWidget& row)
{
    for (QWidget* around = row.parentWidget(); around != nullptr; around = around->parentWidget()) {
        if (auto* area = qobject_cast<QScrollArea*>(around)) {
            area->ensureWidgetVisible(&row, 0, kSeenAround);
        }
    }
}

void flashRow(QWidget& row)
{
    auto* border = new QFrame(&row);
    border->setObjectName(QStringLiteral("flash"));
    border->setAttribute(Qt::WA_TransparentForMouseEvents);
    border->setStyleSheet(
        QStringLiteral("#flash { border: 2px solid palette(highlight); border-radius: 4px; }"));
    border->setGeometry(row.rect());
    border->show();
    QTimer::singleShot(kFlashMilliseconds, border, &QObject::deleteLater);
}

} // namespace crowd::widgets
