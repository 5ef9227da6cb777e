// SPDX-License-Identifier: MIT
#include "widgets/docks/DockBase.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <QtCore/QTimer>
#include <QtGui/QAction>
#include <QtGui/QScreen>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMainWindow>
#include <QtWidgets/QScrollBar>

#include "widgets/actions/OwnKeys.h"

namespace crowd::widgets {

namespace {

constexpr int kFloatShift = 24; ///< logical pixels
constexpr int kRoomAround = 12;
constexpr QSize kLeastFloating{280, 400};

/// Where a window is wholly on the screen, its title in any case.
QPoint onScreen(const QRect& screen, const QRect& window)
{
    return {std::max(screen.left(), std::min(window.left(), screen.right() - window.width())),
            std::max(screen.top(), std::min(window.top(), screen.bottom() - window.height()))};
}

/// Over the picture, next to the side that it has come from, so that it covers no other panel.
QPoint besidePanels(const QDockWidget& dock)
{
    const auto* window = qobject_cast<const QMainWindow*>(dock.parentWidget());
    const QWidget* picture = window != nullptr ? window->centralWidget() : nullptr;
    if (picture == nullptr) {
        return dock.pos() + QPoint(kFloatShift, -kFloatShift);
    }
    const QRect room(picture->mapToGlobal(QPoint()), picture->size());
    const bool isFromRight = dock.geometry().center().x() > room.center().x();
    const int x = isFromRight ? room.right() - kFloatShift - dock.frameGeometry().width()
                              : room.left() + kFloatShift;
    return {x, std::max(dock.pos().y() - kFloatShift, room.top() + kFloatShift)};
}

/// The same widgets of two panels that were made by the same lines; none where they differ.
template<class Widget>
std::vector<std::pair<Widget*, Widget*>> pairs(const QWidget& before, const QWidget& now)
{
    const QList<Widget*> old = before.findChildren<Widget*>();
    const QList<Widget*> fresh = now.findChildren<Widget*>();
    std::vector<std::pair<Widget*, Widget*>> both;
    for (qsizetype i = 0; old.size() == fresh.size() && i < old.size(); ++i) {
        both.emplace_back(old[i], fresh[i]);
    }
    return both;
}

void unfoldAlike(const QTreeWidgetItem& before, QTreeWidgetItem& now)
{
    for (int i = 0; i < std::min(before.childCount(), now.childCount()); ++i) {
        now.child(i)->setExpanded(before.child(i)->isExpanded());
        unfoldAlike(*before.child(i), *now.child(i));
    }
}

/// Once the new panel has its size: before, there is nothing to scroll.
void scrollAlike(const QWidget& before, const QWidget& now)
{
    for (const auto& [old, fresh] : pairs<QScrollBar>(before, now)) {
        if (old->value() > old->minimum()) {
            QTimer::singleShot(0, fresh,
                               [bar = fresh, value = old->value()] { bar->setValue(value); });
        }
    }
}

} // namespace

DockBase::DockBase(const QString& title, const char* objectName, QWidget* parent)
    : QDockWidget(title, parent)
{
    setObjectName(QLatin1String(objectName));
    if (auto* button = findChild<QAbstractButton*>(QStringLiteral("qt_dockwidget_floatbutton"))) {
        connect(button, &QAbstractButton::clicked, this, [this] {
            if (isFloating()) { // where it was it would look as before
                resize(size().expandedTo(kLeastFloating));
                move(onScreen(screen()->availableGeometry(),
                              {besidePanels(*this), frameGeometry().size()}));
            }
        });
    }
}

void setUpOutline(QTreeWidget& tree)
{
    tree.setColumnCount(2);
    tree.header()->hide();
    tree.header()->setStretchLastSection(false);
    tree.header()->setSectionResizeMode(0, QHeaderView::Stretch);
    tree.header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    tree.setFrameShape(QFrame::NoFrame);
    tree.setContextMenuPolicy(Qt::CustomContextMenu);
    tree.setEditTriggers(QAbstractItemView::EditKeyPressed);
}

void DockBase::takeOver(DockBase& before)
{
    for (const auto& [old, fresh] : pairs<QAbstractButton>(before, *this)) {
        if (fresh->isCheckable() && fresh->isChecked() != old->isChecked()) {
            fresh->setChecked(old->isChecked());
        }
    }
    for (const auto& [old, fresh] : pairs<QTreeWidget>(before, *this)) {
        unfoldAlike(*old->invisibleRootItem(), *fresh->invisibleRootItem());
    }
    scrollAlike(before, *this);
}

void DockBase::setScrolledContent(QWidget* content)
{
    auto* area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(content);
    area->setMinimumWidth(content->minimumSizeHint().width() + 18);
    setWidget(area);
}

void DockBase::removeByKey(QWidget& list, const std::function<void()>& remove)
{
    auto* action = new QAction(tr("Remove"), this);
    action->setShortcut(QKeySequence::Delete);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, remove);
    list.addAction(action);
    keepKeysOfOwnActions(list);
}

void DockBase::showRenaming(QListWidget& list)
{
    list.scrollToItem(list.currentItem());
    // Once all have their places: the list has grown by the row.
    QTimer::singleShot(0, &list, [this, &list] {
        const auto* field = list.viewport()->findChild<QLineEdit*>();
        auto* area = qobject_cast<QScrollArea*>(widget());
        if (field != nullptr && area != nullptr) {
            list.scrollToItem(list.currentItem());
            const QPoint place = field->mapTo(area->widget(), field->rect().bottomLeft());
            area->ensureVisible(0, place.y() - field->height(), 0, kRoomAround);
            area->ensureVisible(0, place.y(), 0, kRoomAround);
        }
    });
}

} // namespace crowd::widgets
