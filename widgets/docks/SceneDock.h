// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QTimer>

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QMenu;
class QTreeWidget;
class QTreeWidgetItem;

namespace crowd::widgets {

class PlacementForm;

/// What the scene consists of: stages, templates with how many people each has, cameras. Below
/// stands how the chosen stage is placed and what the chosen camera sees, else what the view does.
/// A double click goes to a camera or selects the people of a template; F2 renames.
class SceneDock : public DockBase
{
    Q_OBJECT

public:
    SceneDock(EditorState& state, QWidget* parent);

Q_SIGNALS:
    void importStageRequested();
    void locateStageRequested(std::uint8_t id);
    void importTemplateRequested();
    void locateTemplateRequested(crowd::model::TemplateId id);
    void removeTemplateRequested(crowd::model::TemplateId id);

protected:
    void changeEvent(QEvent* event) override;

private:
    void rebuild();
    void addStages();
    void addPeople();
    void addCameras();
    [[nodiscard]] const QTreeWidgetItem* chosenItem() const;
    void showPlacement(const QTreeWidgetItem* item);
    void activate(QTreeWidgetItem* item);
    void rename(QTreeWidgetItem* item);
    void renameStage(std::uint8_t id, const std::string& name);
    void renameTemplate(model::TemplateId id, const std::string& name);
    void showMenu(const QPoint& position);
    void fillMenu(QMenu& menu, QTreeWidgetItem* item);
    void fillStageMenu(QMenu& menu, std::uint8_t id);
    void fillTemplateMenu(QMenu& menu, model::TemplateId id);
    void fillCameraMenu(QMenu& menu, const QString& name);
    void addLookMenu(QMenu& menu, const QString& camera);
    void removeStage(std::uint8_t id);
    void removeCurrent();

    EditorState& m_state;
    QTreeWidget* m_tree;        ///< child
    PlacementForm* m_placement; ///< child
    QTimer m_rebuild;           ///< many changes in a stroke make few rebuilds
    bool m_isFilling = false;
};

} // namespace crowd::widgets
