// SPDX-License-Identifier: MIT
#include "widgets/docks/SceneDock.h"

#include <algorithm>
#include <map>

#include <QtCore/QEvent>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeWidget>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "model/document/SceneEdit.h"
#include "widgets/commands/ViewCommands.h"
#include "widgets/docks/PlacementForm.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

enum OutlineItemType {
    HeadingItem = QTreeWidgetItem::UserType,
    StageItem,
    TemplateItem,
    CameraItem
};

constexpr int kRebuildMs = 150;

/// How many people have each value.
template<class T>
std::map<T, int> countsOf(std::span<const T> column)
{
    std::map<T, int> counts;
    for (const T value : column) {
        ++counts[value];
    }
    return counts;
}

bool changesOutline(const model::SceneChange& change)
{
    const auto* columns = std::get_if<model::ColumnsChanged>(&change);
    return columns == nullptr || columns->columns.contains(model::ColumnId::Template);
}

QTreeWidgetItem* heading(QTreeWidget* tree, const char* icon, const QString& text)
{
    auto* item = new QTreeWidgetItem(tree, {text}, HeadingItem);
    item->setIcon(0, iconNamed(icon));
    item->setExpanded(true);
    return item;
}

} // namespace

SceneDock::SceneDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Scene"), "scene", parent), m_state(state), m_tree(new QTreeWidget(this)),
      m_placement(new PlacementForm(state, this))
{
    setUpOutline(*m_tree);
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(m_tree, 1);
    layout->addWidget(m_placement);
    setWidget(content);

    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(kRebuildMs);
    connect(&m_rebuild, &QTimer::timeout, this, &SceneDock::rebuild);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (changesOutline(change) && !m_rebuild.isActive()) {
                    m_rebuild.start();
                }
                if (isOneOf<model::CamerasChanged>(change)) {
                    m_placement->followCameras();
                } else if (isOneOf<model::StagesChanged>(change)) {
                    m_placement->refresh();
                }
            });
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, [this] {
        if (!m_isFilling) {
            showPlacement(chosenItem());
        }
    });
    connect(m_tree, &QTreeWidget::itemDoubleClicked, this, &SceneDock::activate);
    connect(m_tree, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        if (!m_isFilling) {
            rename(item);
        }
    });
    connect(m_tree, &QTreeWidget::customContextMenuRequested, this, &SceneDock::showMenu);
    removeByKey(*m_tree, [this] { removeCurrent(); });
    rebuild();
}

void SceneDock::changeEvent(QEvent* event)
{
    DockBase::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        m_rebuild.start(); // icons in the theme's colour
    }
}

void SceneDock::rebuild()
{
    if (m_tree->viewport()->findChild<QLineEdit*>() != nullptr) {
        m_rebuild.start(); // not under the hands of who renames
        return;
    }
    const QTreeWidgetItem* before = chosenItem();
    const int type = before != nullptr ? before->type() : 0;
    const QVariant id = before != nullptr ? before->data(0, kIdRole) : QVariant();
    m_isFilling = true;
    m_tree->clear();
    addStages();
    addPeople();
    addCameras();
    for (QTreeWidgetItemIterator each(m_tree); type != 0 && *each != nullptr; ++each) {
        if ((*each)->type() == type && (*each)->data(0, kIdRole) == id) {
            m_tree->setCurrentItem(*each);
            break;
        }
    }
    m_isFilling = false;
    showPlacement(chosenItem());
}

/// Null: none, after a click beside them.
const QTreeWidgetItem* SceneDock::chosenItem() const
{
    const QList<QTreeWidgetItem*> chosen = m_tree->selectedItems();
    return chosen.isEmpty() ? nullptr : chosen.front();
}

void SceneDock::showPlacement(const QTreeWidgetItem* item)
{
    const QVariant id = item != nullptr ? item->data(0, kIdRole) : QVariant();
    if (item != nullptr && item->type() == StageItem) {
        m_placement->showStage(static_cast<std::uint8_t>(id.toUInt()));
    } else if (item != nullptr && item->type() == CameraItem) {
        m_placement->showCamera(id.toString());
    } else {
        m_placement->showView();
    }
}

void SceneDock::addStages()
{
    QTreeWidgetItem* stages = heading(m_tree, "stage", tr("Stage"));
    for (const model::StageEntry& entry : m_state.scene().stages) {
        auto* item = new QTreeWidgetItem(stages, {QString::fromStdString(entry.name)}, StageItem);
        item->setData(0, kIdRole, entry.id);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setToolTip(0, entry.problem.empty() ? QString::fromStdString(entry.path)
                                                  : model::translated(entry.problem));
        item->setText(1, entry.asset
                             ? tr("%n seats", nullptr, static_cast<int>(entry.asset->seats.size()))
                             : tr("missing"));
    }
}

void SceneDock::addPeople()
{
    auto counts = countsOf(m_state.scene().population.column(model::columns::templateId));
    QTreeWidgetItem* templates = heading(m_tree, "person", tr("Characters"));
    for (const model::TemplateEntry& entry : m_state.scene().templates) {
        auto* item =
            new QTreeWidgetItem(templates, {QString::fromStdString(entry.name)}, TemplateItem);
        item->setData(0, kIdRole, entry.id);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setToolTip(0, entry.problem.empty() ? QString::fromStdString(entry.path)
                                                  : model::translated(entry.problem));
        item->setText(1, entry.asset ? QLocale().toString(counts[entry.id]) : tr("missing"));
    }
}

void SceneDock::addCameras()
{
    QTreeWidgetItem* cameras = heading(m_tree, "camera", tr("Cameras"));
    for (const model::NamedCamera& camera : m_state.scene().cameras) {
        auto* item =
            new QTreeWidgetItem(cameras, {QString::fromStdString(camera.name)}, CameraItem);
        item->setData(0, kIdRole, QString::fromStdString(camera.name));
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        if (const auto* look = model::findLook(m_state.scene().looks, camera.look)) {
            item->setText(1, QString::fromStdString(look->name));
            item->setToolTip(1, tr("The look that the view takes on with this camera"));
        }
    }
}

void SceneDock::activate(QTreeWidgetItem* item)
{
    const model::Population& people = m_state.scene().population;
    const QVariant id = item->data(0, kIdRole);
    if (item->type() == CameraItem) {
        goToCamera(m_state, id.toString());
    } else if (item->type() == TemplateItem) {
        m_state.selection().set(peopleWith(people, model::columns::templateId,
                                           static_cast<model::TemplateId>(id.toUInt())));
    }
}

void SceneDock::rename(QTreeWidgetItem* item)
{
    const QString name = item->text(0).trimmed();
    const QVariant id = item->data(0, kIdRole);
    bool isRenamed = false;
    if (!name.isEmpty()) {
        if (item->type() == CameraItem) {
            isRenamed = renameCamera(m_state, id.toString(), name);
        } else if (item->type() == StageItem) {
            renameStage(static_cast<std::uint8_t>(id.toUInt()), name.toStdString());
        } else if (item->type() == TemplateItem) {
            renameTemplate(static_cast<model::TemplateId>(id.toUInt()), name.toStdString());
        }
    }
    if (!isRenamed) {
        m_rebuild.start(); // what was refused gets its old name back
    }
}

void SceneDock::renameStage(std::uint8_t id, const std::string& name)
{
    const model::StageEntry* entry = m_state.scene().findStage(id);
    if (entry != nullptr && entry->name != name) {
        model::StageEntry renamed = *entry;
        renamed.name = name;
        m_state.document().edit(tr("Rename stage"),
                                [&](model::SceneEdit& edit) { edit.changeStage(renamed); });
    }
}

void SceneDock::renameTemplate(model::TemplateId id, const std::string& name)
{
    const model::TemplateEntry* entry = m_state.scene().findTemplate(id);
    if (entry != nullptr && entry->name != name) {
        model::TemplateEntry renamed = *entry;
        renamed.name = name;
        m_state.document().edit(tr("Rename template"),
                                [&](model::SceneEdit& edit) { edit.changeTemplate(renamed); });
    }
}

void SceneDock::removeStage(std::uint8_t id)
{
    m_state.document().edit(tr("Remove stage"),
                            [&](model::SceneEdit& edit) { edit.removeStage(id); });
}

/// As its menu does.
void SceneDock::removeCurrent()
{
    const QTreeWidgetItem* item = m_tree->currentItem();
    if (item == nullptr) {
        return;
    }
    const QVariant id = item->data(0, kIdRole);
    if (item->type() == CameraItem) {
        removeCamera(m_state, id.toString());
    } else if (item->type() == StageItem) {
        removeStage(static_cast<std::uint8_t>(id.toUInt()));
    } else if (item->type() == TemplateItem) {
        Q_EMIT removeTemplateRequested(static_cast<model::TemplateId>(id.toUInt()));
    }
}

void SceneDock::fillStageMenu(QMenu& menu, std::uint8_t id)
{
    menu.addAction(iconNamed("locate"), tr("Locate File…"), this,
                   [this, id] { Q_EMIT locateStageRequested(id); });
    menu.addAction(iconNamed("delete"), tr("Remove"), this, [this, id] { removeStage(id); });
}

void SceneDock::fillTemplateMenu(QMenu& menu, model::TemplateId id)
{
    menu.addAction(iconNamed("select-all"), tr("Select These Characters"), this, [this, id] {
        m_state.selection().set(
            peopleWith(m_state.scene().population, model::columns::templateId, id));
    });
    menu.addAction(iconNamed("locate"), tr("Locate File…"), this,
                   [this, id] { Q_EMIT locateTemplateRequested(id); });
    menu.addAction(iconNamed("delete"), tr("Remove"), this,
                   [this, id] { Q_EMIT removeTemplateRequested(id); });
}

void SceneDock::fillCameraMenu(QMenu& menu, const QString& name)
{
    menu.addAction(iconNamed("camera"), tr("Go There"), this,
                   [this, name] { goToCamera(m_state, name); });
    menu.addAction(iconNamed("frame"), tr("Set to This View"), this,
                   [this, name] { updateCamera(m_state, name); });
    addLookMenu(menu, name);
    menu.addAction(iconNamed("delete"), tr("Remove"), this,
                   [this, name] { removeCamera(m_state, name); });
}

/// What the view looks like from this camera.
void SceneDock::addLookMenu(QMenu& menu, const QString& camera)
{
    QMenu* choices = menu.addMenu(iconNamed("look"), tr("Look"));
    const model::Scene& scene = m_state.scene();
    const auto found =
        std::ranges::find(scene.cameras, camera.toStdString(), &model::NamedCamera::name);
    const model::LookId now = found != scene.cameras.end() ? found->look : 0;
    const auto add = [this, camera, choices, now](const QString& text, model::LookId look) {
        QAction* action = choices->addAction(
            text, this, [this, camera, look] { setCameraLook(m_state, camera, look); });
        action->setCheckable(true);
        action->setChecked(look == now);
    };
    add(tr("As It Is Elsewhere"), 0);
    for (const model::LookPreset& each : scene.looks) {
        add(QString::fromStdString(each.name), each.id);
    }
    if (scene.looks.empty()) {
        choices->addAction(tr("Looks are made in the panel Looks"))->setEnabled(false);
    }
}

void SceneDock::fillMenu(QMenu& menu, QTreeWidgetItem* item)
{
    const QVariant id = item->data(0, kIdRole);
    switch (item->type()) {
    case StageItem:
        fillStageMenu(menu, static_cast<std::uint8_t>(id.toUInt()));
        break;
    case TemplateItem:
        fillTemplateMenu(menu, static_cast<model::TemplateId>(id.toUInt()));
        break;
    case CameraItem:
        fillCameraMenu(menu, id.toString());
        break;
    default:
        break;
    }
    if (item->flags().testFlag(Qt::ItemIsEditable)) {
        menu.addAction(iconNamed("rename"), tr("Rename"), this,
                       [this, item] { m_tree->editItem(item, 0); });
    }
    menu.addSeparator();
}

void SceneDock::showMenu(const QPoint& position)
{
    QMenu menu(this);
    if (QTreeWidgetItem* item = m_tree->itemAt(position)) {
        fillMenu(menu, item);
    }
    menu.addAction(iconNamed("camera-add"), tr("Keep This View"), this,
                   [this] { (void)addCamera(m_state); });
    menu.addAction(iconNamed("import"), tr("Import Stage…"), this,
                   [this] { Q_EMIT importStageRequested(); });
    menu.addAction(iconNamed("import"), tr("Import Template…"), this,
                   [this] { Q_EMIT importTemplateRequested(); });
    menu.exec(m_tree->viewport()->mapToGlobal(position));
}

} // namespace crowd::widgets
