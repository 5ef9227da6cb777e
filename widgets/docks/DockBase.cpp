// SPDX-License-Identifier: MIT
#include "widgets/docks/DockBase.h"

namespace crowd::widgets {

DockBase::DockBase(const QString& title, const char* objectName, QWidget* parent)
    : QDockWidget(title, parent)
{
    setObjectName(QLatin1String(objectName));
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
