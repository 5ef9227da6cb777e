// SPDX-License-Identifier: MIT
#include "widgets/docks/GroupsDock.h"

#include <map>

#include <QtCore/QEvent>
#include <QtCore/QLocale>
#include <QtGui/QPainter>
#include <QtWidgets/QApplication>
#include <QtWidgets/QColorDialog>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "widgets/commands/GroupCommands.h"
#include "widgets/forms/PanelButton.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

using model::Group;
using model::GroupId;

namespace {

constexpr int kGroupRebuildMs = 100;
constexpr int kSymbolWidth = 26;

QIcon swatchOf(const model::PaintColor& color)
{
    QPixmap filled(14, 14);
    filled.fill(Qt::transparent);
    QPainter painter(&filled);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(color[0], color[1], color[2]));
    painter.drawRoundedRect(filled.rect(), 3, 3);
    painter.end();
    return QIcon(filled);
}

bool touchesGroups(const model::SceneChange& change)
{
    const auto* columns = std::get_if<model::ColumnsChanged>(&change);
    return (columns != nullptr && columns->columns.contains(model::ColumnId::Group)) ||
           isOneOf<model::GroupsChanged, model::IndividualsAdded, model::IndividualsRemoved,
                   model::SceneReplaced>(change);
}

} // namespace

GroupsDock::GroupsDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Groups"), "groups", parent), m_state(state), m_tree(new QTreeWidget(this))
{
    setUpOutline(*m_tree);
    m_tree->setRootIsDecorated(false);
    m_tree->setColumnCount(ColumnCount);
    m_tree->header()->setMinimumSectionSize(kSymbolWidth);
    for (const int column : {Eye, Lock}) {
        m_tree->header()->setSectionResizeMode(column, QHeaderView::Fixed);
        m_tree->header()->resizeSection(column, kSymbolWidth);
    }
    m_tree->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(Count, QHeaderView::ResizeToContents);
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(m_tree, 1);
    layout->addWidget(buttons());
    setWidget(content);
    connectParts();
    rebuild();
}

QWidget* GroupsDock::buttons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const char* icon, const QString& tip, const char* name, auto act) {
        QToolButton* button = panelButton(row, icon, tip, name);
        layout->addWidget(button);
        connect(button, &QToolButton::clicked, this, act);
    };
    add("add", tr("A new group of those who are selected"), "newGroup",
        [this] { groupSelected(); });
    add("group", tr("Take the selected characters into the active group"), "takeIn",
        [this] { putSelectionInGroup(m_state, currentId()); });
    add("select-all", tr("Select the characters of the active group"), "selectGroup",
        [this] { selectGroup(m_state, currentId()); });
    layout->addStretch(1);
    add("delete", tr("Delete the active group; its characters stay"), "deleteGroup", [this] {
        if (currentId() != 0) {
            deleteGroup(m_state, currentId());
        }
    });
    return row;
}

/// Its name is what comes next.
void GroupsDock::groupSelected()
{
    groupSelection(m_state);
    rebuild();
    edit(currentId());
}

/// Its name, to be typed.
void GroupsDock::edit(GroupId id)
{
    for (int row = 0; id != 0 && row < m_tree->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = m_tree->topLevelItem(row);
        if (item->data(0, kIdRole).toUInt() == id) {
            m_tree->setCurrentItem(item, Name);
            m_tree->editItem(item, Name);
        }
    }
}

void GroupsDock::connectParts()
{
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(kGroupRebuildMs);
    connect(&m_rebuild, &QTimer::timeout, this, &GroupsDock::rebuild);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (touchesGroups(change) && !m_rebuild.isActive()) {
                    m_rebuild.start();
                }
            });
    connect(&m_state, &EditorState::brushChanged, this, &GroupsDock::markActive);
    connect(m_tree, &QTreeWidget::itemClicked, this, &GroupsDock::click);
    connect(m_tree, &QTreeWidget::itemDoubleClicked, this,
            [this](QTreeWidgetItem* item, int column) {
                if (column == Name && item->data(0, kIdRole).toUInt() != 0) {
                    m_tree->editItem(item, Name);
                }
            });
    connect(m_tree, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (!m_isFilling) {
            rename(item, column);
        }
    });
    connect(m_tree, &QTreeWidget::customContextMenuRequested, this, &GroupsDock::showMenu);
}

void GroupsDock::changeEvent(QEvent* event)
{
    DockBase::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        m_rebuild.start(); // icons in the theme's colour
    }
}

GroupId GroupsDock::currentId() const
{
    return activeGroup(m_state);
}

Group GroupsDock::groupOf(GroupId id) const
{
    if (const Group* known = m_state.scene().findGroup(id)) {
        return *known;
    }
    Group group;
    group.id = id;
    group.name = tr("Group %1").arg(id).toStdString();
    group.isParty = true; // as a number without a group is
    return group;
}

void GroupsDock::rebuild()
{
    if (m_tree->viewport()->findChild<QLineEdit*>() != nullptr) {
        m_rebuild.start(); // not under the hands of who renames
        return;
    }
    std::map<GroupId, int> counts;
    for (const Group& group : m_state.scene().groups) {
        counts[group.id] = 0;
    }
    counts[0] = 0;
    for (const GroupId group : m_state.scene().population.column(model::columns::group)) {
        ++counts[group];
    }
    m_isFilling = true;
    m_tree->clear();
    for (const auto& [id, count] : counts) {
        addRow(id, count);
    }
    m_isFilling = false;
    markActive();
}

void GroupsDock::addRow(GroupId id, int count)
{
    auto* item = new QTreeWidgetItem(m_tree);
    item->setData(0, kIdRole, id);
    item->setText(Count, QLocale().toString(count));
    item->setTextAlignment(Count, Qt::AlignRight | Qt::AlignVCenter);
    if (id == 0) {
        item->setText(Name, tr("In no group"));
        return;
    }
    const Group group = groupOf(id);
    item->setText(Name, QString::fromStdString(group.name));
    item->setIcon(Name, swatchOf(group.color));
    item->setIcon(Eye, iconNamed(group.isHidden ? "eye-closed" : "eye"));
    item->setToolTip(Eye, group.isHidden ? tr("Hidden: click to show")
                                         : tr("Shown: click to hide, with Alt to show it alone"));
    item->setIcon(Lock, iconNamed(group.isLocked ? "lock" : "lock-open"));
    item->setToolTip(Lock, group.isLocked ? tr("Locked: click to let brushes work on it")
                                          : tr("Click to lock: no brush touches it then"));
    item->setFlags(item->flags() | Qt::ItemIsEditable);
}

void GroupsDock::markActive()
{
    const GroupId active = currentId();
    m_isFilling = true;
    for (int row = 0; row < m_tree->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = m_tree->topLevelItem(row);
        const bool isActive = item->data(0, kIdRole).toUInt() == active;
        QFont font = m_tree->font();
        font.setBold(isActive);
        item->setFont(Name, font);
        if (isActive) {
            m_tree->setCurrentItem(item, Name);
        }
    }
    m_isFilling = false;
}

void GroupsDock::click(QTreeWidgetItem* item, int column)
{
    const GroupId id = item->data(0, kIdRole).toUInt();
    if (column == Eye && id != 0) {
        if (QApplication::keyboardModifiers().testFlag(Qt::AltModifier)) {
            showAlone(id);
        } else {
            change(id, tr("Show or hide a group"), [](Group& group) { group.isHidden ^= true; });
        }
    } else if (column == Lock && id != 0) {
        change(id, tr("Lock or unlock a group"), [](Group& group) { group.isLocked ^= true; });
    } else {
        setActiveGroup(m_state, id);
    }
    markActive();
}

void GroupsDock::showAlone(GroupId id)
{
    showGroupAlone(m_state, id);
}

void GroupsDock::rename(QTreeWidgetItem* item, int column)
{
    const GroupId id = item->data(0, kIdRole).toUInt();
    const QString name = item->text(Name).trimmed();
    if (column == Name && id != 0 && !name.isEmpty()) {
        change(id, tr("Rename a group"), [&](Group& group) { group.name = name.toStdString(); });
    }
    m_rebuild.start(); // what was refused gets its old name back
}

void GroupsDock::change(GroupId id, const QString& undoText,
                        const std::function<void(Group&)>& apply)
{
    Group group = groupOf(id);
    apply(group);
    editGroups(m_state, undoText, [&](model::SceneEdit& edit) { model::changeGroup(edit, group); });
}

void GroupsDock::chooseColor(GroupId id)
{
    const model::PaintColor now = groupOf(id).color;
    const QColor chosen = QColorDialog::getColor(QColor(now[0], now[1], now[2]), this);
    if (chosen.isValid()) {
        change(id, tr("Colour of a group"), [&](Group& group) {
            group.color = {static_cast<std::uint8_t>(chosen.red()),
                           static_cast<std::uint8_t>(chosen.green()),
                           static_cast<std::uint8_t>(chosen.blue())};
        });
    }
}

void GroupsDock::fillMenu(QMenu& menu, GroupId id)
{
    menu.addAction(iconNamed("select-all"), tr("Select These Characters"), this,
                   [this, id] { selectGroup(m_state, id); });
    QAction* take = menu.addAction(iconNamed("group"),
                                   id == 0 ? tr("Take the Selected Out of Their Groups")
                                           : tr("Take the Selected In"),
                                   this, [this, id] { putSelectionInGroup(m_state, id); });
    take->setEnabled(!m_state.selection().isEmpty());
    if (id == 0) {
        return;
    }
    menu.addSeparator();
    menu.addAction(iconNamed("eye"), tr("Show It Alone"), this, [this, id] { showAlone(id); });
    menu.addAction(tr("Colour…"), this, [this, id] { chooseColor(id); });
    QAction* party = menu.addAction(tr("Walk as One Party"), this, [this, id] {
        change(id, tr("Party or not"), [](Group& group) { group.isParty ^= true; });
    });
    party->setToolTip(tr("All of them take the same branch of a path and keep together"));
    party->setCheckable(true);
    party->setChecked(groupOf(id).isParty);
    menu.addSeparator();
    menu.addAction(iconNamed("delete"), tr("Delete the Group"), this,
                   [this, id] { deleteGroup(m_state, id); });
}

void GroupsDock::showMenu(const QPoint& position)
{
    QMenu menu(this);
    menu.setToolTipsVisible(true);
    if (QTreeWidgetItem* item = m_tree->itemAt(position)) {
        fillMenu(menu, item->data(0, kIdRole).toUInt());
        if (item->flags().testFlag(Qt::ItemIsEditable)) {
            menu.addAction(iconNamed("rename"), tr("Rename"), this,
                           [this, item] { m_tree->editItem(item, Name); });
        }
        menu.addSeparator();
    }
    menu.addAction(iconNamed("add"), tr("New Group of the Selected"), this,
                   &GroupsDock::groupSelected);
    menu.exec(m_tree->viewport()->mapToGlobal(position));
}

} // namespace crowd::widgets
