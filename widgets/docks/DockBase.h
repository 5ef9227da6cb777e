// SPDX-License-Identifier: MIT
#pragma once

#include <QtWidgets/QDockWidget>
#include <QtWidgets/QScrollArea>

namespace crowd::widgets {

/// A dock whose content scrolls when the dock is small and that never forces the window wider.
class DockBase : public QDockWidget
{
    Q_OBJECT

protected:
    DockBase(const QString& title, const char* objectName, QWidget* parent);
    void setScrolledContent(QWidget* content);
};

} // namespace crowd::widgets
