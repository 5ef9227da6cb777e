// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QTimer>

#include "model/scene/Group.h"
#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QMenu;

namespace crowd::widgets {

/// The groups as layers: an eye, a lock, the name with its colour, how many there are. The group
/// that is chosen is the active one: new characters come into it, and the group brush paints it.
/// Main thread.
class GroupsDock : public DockBase
{
    Q_OBJECT

public:
    enum Column { Eye, Lock, Name, Count, ColumnCount };

    GroupsDock(EditorState& state, QWidget* parent);

    /// As the eye of a row with Alt: the others are hidden, or all shown.
    void showAlone(model::GroupId id);

protected:
    void changeEvent(QEvent* event) override;

private:
    void connectParts();
    void groupSelected();
    void edit(model::GroupId id);
    [[nodiscard]] QWidget* buttons();
    void rebuild();
    void addRow(model::GroupId id, int count);
    void markActive();
    void click(QTreeWidgetItem* item, int column);
    void rename(QTreeWidgetItem* item, int column);
    void showMenu(const QPoint& position);
    void fillMenu(QMenu& menu, model::GroupId id);
    void chooseColor(model::GroupId id);
    /// The group, or what one of that number would be.
    [[nodiscard]] model::Group groupOf(model::GroupId id) const;
    void change(model::GroupId id, const QString& undoText,
                const std::function<void(model::Group&)>& apply);
    [[nodiscard]] model::GroupId currentId() const;

    EditorState& m_state;
    QTimer m_rebuild;
    bool m_isFilling = false;
    QTreeWidget* m_tree; ///< child
};

} // namespace crowd::widgets
