// SPDX-License-Identifier: MIT
#include "widgets/docks/DockBase.h"

#include <QtWidgets/QHeaderView>

namespace crowd::widgets {

DockBase::DockBase(const QString& title, const char* objectName, QWidget* parent)
    : QDockWidget(title, parent)
{
    setObjectName(QLatin1String(objectName));
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

} // namespace crowd::widgets
