// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtWidgets/QDockWidget>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QTreeWidget>

class QListWidget;

namespace crowd::widgets {

inline constexpr int kIdRole = Qt::UserRole; ///< where a list keeps the id of what a row shows

/// Makes a tree one of names with their values beside them, renamed by key, with a menu of its own.
void setUpOutline(QTreeWidget& tree);

/// A dock whose content scrolls when the dock is small and that never forces the window wider.
class DockBase : public QDockWidget
{
    Q_OBJECT

public:
    /// As the same panel that was made before it, in another language: what is unfolded, ticked
    /// and scrolled to, and all else that only the panel knows. It goes afterwards.
    virtual void takeOver(DockBase& before);

protected:
    DockBase(const QString& title, const char* objectName, QWidget* parent);
    void setScrolledContent(QWidget* content);
    /// Scrolls the content so that the field of who renames a row of a list in it is seen.
    void showRenaming(QListWidget& list);
    /// The key Delete removes what is chosen in the list that has the focus.
    void removeByKey(QWidget& list, const std::function<void()>& remove);
};

} // namespace crowd::widgets
