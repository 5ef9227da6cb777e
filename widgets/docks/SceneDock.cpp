// SPDX-License-Identifier: MIT
#include "widgets/docks/SceneDock.h"

#include <map>

#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QMenu>
#include <QtWidgets/QTreeWidget>
#include <QtWidgets/QVBoxLayout>

#include "model/document/SceneEdit.h"
#include "widgets/docks/LightForm.h"
#include "widgets/theme/Icons.h"
#include "widgets/viewport/ViewCommands.h"

namespace crowd::widgets {

namespace {

enum ItemType { Heading = QTreeWidgetItem::UserType, StageItem, TemplateItem, CameraItem };

constexpr int kIdRole = Qt::UserRole;
constexpr int kRebuildMs = 150;

QTreeWidgetItem* heading(QTreeWidget* tree, const char* icon, const QString& text)
{
    auto* item = new QTreeWidgetItem(tree, {text}, Heading);
    item->setIcon(0, iconNamed(icon));
    item->setExpanded(true);
    return item;
}

} // namespace

SceneDock::SceneDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Scene"), "scene", parent), m_state(state), m_tree(new QTreeWidget(this))
{
    m_tree->setColumnCount(2);
    m_tree->header()->hide();
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->setEditTriggers(QAbstractItemView::EditKeyPressed);
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(m_tree, 1);
    layout->addWidget(new LightForm(m_state, content));
    setWidget(content);

    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(kRebuildMs);
    connect(&m_rebuild, &QTimer::timeout, this, &SceneDock::rebuild);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (!std::holds_alternative<model::ColumnsChanged>(change) &&
                    !m_rebuild.isActive()) {
                    m_rebuild.start();
                }
            });
    connect(m_tree, &QTreeWidget::itemDoubleClicked, this, &SceneDock::activate);
    connect(m_tree, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        if (!m_isFilling) {
            rename(item);
        }
    });
    connect(m_tree, &QTreeWidget::customContextMenuRequested, this, &SceneDock::showMenu);
    rebuild();
}

void SceneDock::rebuild()
{
    m_isFilling = true;
    m_tree->clear();
    const model::Scene& scene = m_state.scene();
    QTreeWidgetItem* stages = heading(m_tree, "stage", tr("Stage"));
    for (const model::StageEntry& entry : scene.stages) {
        auto* item = new QTreeWidgetItem(stages, {QString::fromStdString(entry.name)}, StageItem);
        item->setData(0, kIdRole, entry.id);
        item->setToolTip(
            0, QString::fromStdString(entry.problem.empty() ? entry.path : entry.problem));
        item->setText(1, entry.asset
                             ? tr("%n seats", nullptr, static_cast<int>(entry.asset->seats.size()))
                             : tr("missing"));
    }
    std::map<model::TemplateId, int> counts;
    for (const model::TemplateId id : scene.population.column(model::columns::templateId)) {
        ++counts[id];
    }
    QTreeWidgetItem* templates = heading(m_tree, "person", tr("People"));
    for (const model::TemplateEntry& entry : scene.templates) {
        auto* item =
            new QTreeWidgetItem(templates, {QString::fromStdString(entry.name)}, TemplateItem);
        item->setData(0, kIdRole, entry.id);
        item->setText(1, entry.asset ? QLocale().toString(counts[entry.id]) : tr("missing"));
    }
    QTreeWidgetItem* cameras = heading(m_tree, "camera", tr("Cameras"));
    for (const model::NamedCamera& camera : scene.cameras) {
        auto* item =
            new QTreeWidgetItem(cameras, {QString::fromStdString(camera.name)}, CameraItem);
        item->setData(0, kIdRole, QString::fromStdString(camera.name));
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    m_isFilling = false;
}

void SceneDock::activate(QTreeWidgetItem* item)
{
    if (item->type() == CameraItem) {
        goToCamera(m_state, item->data(0, kIdRole).toString());
    } else if (item->type() == TemplateItem) {
        selectTemplate(static_cast<model::TemplateId>(item->data(0, kIdRole).toUInt()));
    }
}

void SceneDock::selectTemplate(model::TemplateId id)
{
    const model::Population& people = m_state.scene().population;
    const auto templates = people.column(model::columns::templateId);
    std::vector<model::IndividualId> ids;
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (templates[row] == id) {
            ids.push_back(people.ids()[row]);
        }
    }
    m_state.selection().set(ids);
}

void SceneDock::rename(QTreeWidgetItem* item)
{
    if (item->type() != CameraItem) {
        return;
    }
    const QString old = item->data(0, kIdRole).toString();
    if (!renameCamera(m_state, old, item->text(0).trimmed())) {
        m_rebuild.start(); // the old name comes back
    }
}

void SceneDock::removeStage(std::uint8_t id)
{
    const auto edit = m_state.document().beginEdit();
    edit->removeStage(id);
    edit->commit(tr("Remove Stage"));
}

void SceneDock::showMenu(const QPoint& position)
{
    QTreeWidgetItem* item = m_tree->itemAt(position);
    QMenu menu(this);
    if (item != nullptr && item->type() == CameraItem) {
        const QString name = item->data(0, kIdRole).toString();
        menu.addAction(iconNamed("camera"), tr("Go There"), this,
                       [this, name] { goToCamera(m_state, name); });
        menu.addAction(iconNamed("frame"), tr("Set to This View"), this,
                       [this, name] { updateCamera(m_state, name); });
        menu.addAction(iconNamed("rename"), tr("Rename"), this,
                       [this, item] { m_tree->editItem(item, 0); });
        menu.addAction(iconNamed("delete"), tr("Remove"), this,
                       [this, name] { removeCamera(m_state, name); });
        menu.addSeparator();
    } else if (item != nullptr && item->type() == TemplateItem) {
        const auto id = static_cast<model::TemplateId>(item->data(0, kIdRole).toUInt());
        menu.addAction(iconNamed("select-all"), tr("Select These People"), this,
                       [this, id] { selectTemplate(id); });
        menu.addSeparator();
    } else if (item != nullptr && item->type() == StageItem) {
        const auto id = static_cast<std::uint8_t>(item->data(0, kIdRole).toUInt());
        menu.addAction(iconNamed("locate"), tr("Locate File…"), this,
                       [this, id] { Q_EMIT locateStageRequested(id); });
        menu.addAction(iconNamed("delete"), tr("Remove"), this, [this, id] { removeStage(id); });
        menu.addSeparator();
    }
    menu.addAction(iconNamed("camera-add"), tr("Keep This View"), this,
                   [this] { (void)addCamera(m_state); });
    menu.addAction(iconNamed("import"), tr("Import Stage…"), this,
                   [this] { Q_EMIT importStageRequested(); });
    menu.exec(m_tree->viewport()->mapToGlobal(position));
}

} // namespace crowd::widgets
