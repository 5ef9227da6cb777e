// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QTimer>

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QTreeWidget;
class QTreeWidgetItem;

namespace crowd::widgets {

/// What the scene consists of: stages, templates with how many people each has, cameras; and its
/// light. A double click goes to a camera or selects the people of a template.
class SceneDock : public DockBase
{
    Q_OBJECT

public:
    SceneDock(EditorState& state, QWidget* parent);

Q_SIGNALS:
    void importStageRequested();
    void locateStageRequested(std::uint8_t id);

private:
    void rebuild();
    void activate(QTreeWidgetItem* item);
    void rename(QTreeWidgetItem* item);
    void showMenu(const QPoint& position);
    void selectTemplate(model::TemplateId id);
    void removeStage(std::uint8_t id);

    EditorState& m_state;
    QTreeWidget* m_tree;
    QTimer m_rebuild; ///< many changes in a stroke make few rebuilds
    bool m_isFilling = false;
};

} // namespace crowd::widgets
