// SPDX-License-Identifier: MIT
#include "widgets/docks/EnvironmentTree.h"

#include <algorithm>
#include <map>

#include <QtCore/QLocale>
#include <QtGui/QPainter>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QScrollBar>

#include "model/base/Translated.h"
#include "model/document/SceneEdit.h"
#include "model/scene/PlaceShape.h"
#include "widgets/docks/DockBase.h"
#include "widgets/docks/EnvironmentMenu.h"
#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

namespace {

constexpr int kUnfoldedPlaces = 8; ///< longer paths are folded at first
constexpr int kRedrawMs = 30;
constexpr int kTallyMs = 300;
/// Without need the tree takes no room from the form below it; what is left over is its own, too.
constexpr int kLeastRows = 3;
constexpr int kRowsAtOnce = 6;

} // namespace

QIcon colorIcon(const std::array<std::uint8_t, 3>& color)
{
    QPixmap pixmap(14, 14);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(QColor(color[0], color[1], color[2]));
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(1, 1, 12, 12);
    return pixmap;
}

EnvironmentTree::EnvironmentTree(EditorState& state, QWidget* parent)
    : QTreeWidget(parent), m_state(state)
{
    setObjectName(QStringLiteral("environmentTree"));
    setUpOutline(*this);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    followScene();
    followSession();
    connect(&m_state.paths(), &PathFocus::changed, this, &EnvironmentTree::showSelection);
    connect(this, &QTreeWidget::itemSelectionChanged, this, &EnvironmentTree::takeSelection);
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        if (!m_isFilling) {
            rename(item);
        }
    });
    connect(this, &QTreeWidget::customContextMenuRequested, this, &EnvironmentTree::showMenu);
    connect(this, &QTreeWidget::itemExpanded, this, &EnvironmentTree::keepRowsInSight);
    connect(this, &QTreeWidget::itemCollapsed, this, &EnvironmentTree::keepRowsInSight);
}

void EnvironmentTree::followScene()
{
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(kRedrawMs);
    connect(&m_rebuild, &QTimer::timeout, this, &EnvironmentTree::rebuild);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                const bool isShown =
                    std::visit(model::Overloaded{
                                   [](const model::ColumnsChanged& columns) {
                                       return columns.columns.contains(model::ColumnId::Path);
                                   },
                                   [](const model::LightingChanged&) { return false; },
                                   [](const model::LightsChanged&) { return false; },
                                   [](const model::LooksChanged&) { return false; },
                                   [](const model::TimelineChanged&) { return false; },
                                   [](const model::TakesChanged&) { return false; },
                                   [](const model::CamerasChanged&) { return false; },
                                   [](const auto&) { return true; },
                               },
                               change);
                if (isShown && !m_rebuild.isActive()) {
                    m_rebuild.start();
                }
            });
}

void EnvironmentTree::followSession()
{
    m_count.setSingleShot(true);
    m_count.setInterval(kTallyMs);
    SessionControl& session = m_state.session();
    connect(&m_count, &QTimer::timeout, this, [this, &session] {
        m_countedSeconds = session.availableSeconds();
        session.askTally();
    });
    connect(&session, &SessionControl::stateChanged, this, &EnvironmentTree::showCounts);
    connect(&session, &SessionControl::stepped, this, [this, &session] {
        if (session.tally() != m_tally) {
            showCounts();
        }
        const bool isAnother = session.availableSeconds() != m_countedSeconds;
        if (isAnother && isVisible() && !m_count.isActive()) {
            m_count.start();
        }
    });
}

void EnvironmentTree::rebuild()
{
    if (viewport()->findChild<QLineEdit*>() != nullptr) {
        m_rebuild.start(); // not under the hands of who renames
        return;
    }
    m_countedSeconds = -1.0; // people may have been given other paths
    std::map<model::PathId, bool> isOpen;
    for (int i = 0; i < topLevelItemCount(); ++i) {
        const QTreeWidgetItem& item = *topLevelItem(i);
        isOpen[item.data(0, kIdRole).toUInt()] = item.isExpanded();
    }
    const int scrolled = verticalScrollBar()->value();
    m_isFilling = true;
    clear();
    addPaths();
    addPlaces();
    for (int i = 0; i < topLevelItemCount(); ++i) {
        QTreeWidgetItem& item = *topLevelItem(i);
        const auto known = isOpen.find(item.data(0, kIdRole).toUInt());
        item.setExpanded(known != isOpen.end()
                             ? known->second
                             : item.childCount() <= kUnfoldedPlaces || item.type() == KindItem);
    }
    m_isFilling = false;
    keepRowsInSight();
    Q_EMIT rebuilt(); // whoever shows it may hide an empty one
    verticalScrollBar()->setValue(scrolled);
    showCounts();
    showSelection();
}

/// A few rows are seen whatever stands below them.
void EnvironmentTree::keepRowsInSight()
{
    int rows = 0;
    for (QTreeWidgetItemIterator it(this); *it != nullptr && rows < kRowsAtOnce; ++it) {
        rows += (*it)->parent() == nullptr || (*it)->parent()->isExpanded() ? 1 : 0;
    }
    const int height = topLevelItemCount() > 0 ? sizeHintForRow(0) : fontMetrics().height();
    setMinimumHeight(std::max(rows, kLeastRows) * height + 2 * frameWidth());
}

void EnvironmentTree::addPaths()
{
    const model::Scene& scene = m_state.scene();
    for (const model::Path& each : scene.paths) {
        auto* item = new QTreeWidgetItem(this, {QString::fromStdString(each.name)}, PathItem);
        item->setData(0, kIdRole, each.id);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setIcon(0, colorIcon(each.color));
        int index = 0;
        for (const model::PlaceId id : each.places) {
            if (const model::Place* stop = scene.findPlace(id)) {
                addPlace(*item, *stop)->setData(0, kIndexRole, index);
            }
            ++index;
        }
    }
}

/// Those that no path leads over.
void EnvironmentTree::addPlaces()
{
    const model::Scene& scene = m_state.scene();
    QTreeWidgetItem* heading = nullptr;
    for (const model::Place& each : scene.places) {
        const bool isUsed = std::ranges::any_of(scene.paths, [&each](const model::Path& path) {
            return std::ranges::find(path.places, each.id) != path.places.end();
        });
        if (isUsed) {
            continue;
        }
        if (heading == nullptr) {
            heading = new QTreeWidgetItem(this, {tr("Places")}, KindItem);
        }
        addPlace(*heading, each)->setIcon(0, colorIcon(each.color));
    }
}

QTreeWidgetItem* EnvironmentTree::addPlace(QTreeWidgetItem& parent, const model::Place& place)
{
    auto* item = new QTreeWidgetItem(&parent, {QString::fromStdString(place.name)}, PlaceItem);
    item->setData(0, kIdRole, place.id);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    return item;
}

/// Of the run, while there is one; else of the scene, which says nothing of places.
behavior::SessionTally EnvironmentTree::tally() const
{
    if (m_state.session().isRunning()) {
        return m_state.session().tally();
    }
    behavior::SessionTally tally;
    for (const model::PathId path : m_state.scene().population.column(model::columns::path)) {
        ++tally.followers[path];
    }
    return tally;
}

/// The radius of a disc, the length of a line, how much ground an area takes up.
QString EnvironmentTree::sizeText(const model::Place& place)
{
    const auto number = [](float value, int decimals) {
        return QLocale().toString(static_cast<double>(value), 'f', decimals);
    };
    switch (place.shape) {
    case model::PlaceShape::Round:
        break;
    case model::PlaceShape::Line:
        return tr("%1 m long").arg(number(model::lengthOf(place), 1));
    case model::PlaceShape::Area:
        return tr("%1 m²").arg(number(model::areaOf(place), 1));
    }
    return tr("%1 m").arg(number(place.radius, 2));
}

void EnvironmentTree::showCounts()
{
    m_tally = tally();
    const auto countIn = [](const auto& counts, std::uint32_t id) {
        const auto found = counts.find(id);
        return found == counts.end() ? 0 : static_cast<int>(found->second);
    };
    m_isFilling = true;
    for (QTreeWidgetItemIterator it(this); *it != nullptr; ++it) {
        const auto id = (*it)->data(0, kIdRole).toUInt();
        if ((*it)->type() == PathItem) {
            (*it)->setText(1, tr("%n characters", nullptr, countIn(m_tally.followers, id)));
        } else if (const model::Place* place = m_state.scene().findPlace(id)) {
            const QString size = sizeText(*place);
            const int inside = countIn(m_tally.inside, id);
            (*it)->setText(1, inside > 0 ? tr("%n in it · %1", nullptr, inside).arg(size) : size);
        }
    }
    m_isFilling = false;
}

void EnvironmentTree::showSelection()
{
    m_isFilling = true;
    for (QTreeWidgetItemIterator it(this); *it != nullptr; ++it) {
        const auto id = (*it)->data(0, kIdRole).toUInt();
        const bool isPlace = (*it)->type() == PlaceItem;
        const bool isPath = (*it)->type() == PathItem && m_state.paths().places().empty();
        (*it)->setSelected((isPlace && m_state.paths().isSelected(id)) ||
                           (isPath && id != 0 && id == m_state.paths().path()));
    }
    m_isFilling = false;
    showProblems();
    Q_EMIT chosen();
}

/// Once for each choice, and for each place that a chosen path grows by: who scrolls on is left
/// alone.
void EnvironmentTree::scrollToSelection()
{
    QTreeWidgetItem* last = nullptr;
    const PathFocus& focus = m_state.paths();
    for (QTreeWidgetItem* item : selectedItems()) {
        const bool isLast = item->type() == PathItem || focus.places().empty() ||
                            item->data(0, kIdRole).toUInt() == focus.places().back();
        const bool isInPath =
            item->parent() != nullptr && item->parent()->data(0, kIdRole).toUInt() == focus.path();
        last = last == nullptr || (isLast && isInPath) ? item : last;
    }
    const int length = last != nullptr && last->type() == PathItem ? last->childCount() : 0;
    const Shown shown{focus.path(), focus.places(), length};
    if (last == nullptr || shown == m_shown || !isVisible()) {
        return;
    }
    const bool isLonger = shown.path == m_shown.path && length > m_shown.length;
    m_shown = shown;
    if (isLonger && focus.isPainting()) {
        scrollToItem(last->child(length - 1));
    }
    scrollToItem(last);
}

void EnvironmentTree::showMenu(const QPoint& position)
{
    const QTreeWidgetItem* item = itemAt(position);
    if (item == nullptr || m_state.document().isEditOpen() || item->type() == KindItem) {
        return;
    }
    EnvironmentMenu menu(m_state, this);
    const auto id = item->data(0, kIdRole).toUInt();
    if (item->type() == PathItem) {
        menu.fillForPath(id);
    } else if (item->parent()->type() == PathItem) {
        const auto index = static_cast<std::size_t>(item->data(0, kIndexRole).toInt());
        menu.fillForPlace(id,
                          EnvironmentMenu::Stop{item->parent()->data(0, kIdRole).toUInt(), index});
    } else {
        menu.fillForPlace(id, std::nullopt);
    }
    menu.exec(viewport()->mapToGlobal(position));
}

void EnvironmentTree::takeSelection()
{
    if (m_isFilling) {
        return;
    }
    std::vector<model::PlaceId> places;
    model::PathId chosen = m_state.paths().path();
    for (QTreeWidgetItem* item : selectedItems()) {
        const auto id = item->data(0, kIdRole).toUInt();
        if (item->type() == PathItem) {
            chosen = id;
        } else if (item->type() == PlaceItem && std::ranges::find(places, id) == places.end()) {
            places.push_back(id);
            chosen = item->parent()->type() == PathItem ? item->parent()->data(0, kIdRole).toUInt()
                                                        : chosen;
        }
    }
    m_state.paths().select(places);
    m_state.paths().look(chosen);
    showSelection();
}

/// What a session has to say about a path or a place; empty: nothing.
QString EnvironmentTree::problemOf(const QTreeWidgetItem& item) const
{
    const auto id = item.data(0, kIdRole).toUInt();
    const bool isPath = item.type() == PathItem;
    for (const behavior::Problem& problem : m_state.session().problems()) {
        if (id != 0 && item.type() != KindItem && (isPath ? problem.path : problem.place) == id) {
            return model::translated(problem.text);
        }
    }
    return {};
}

void EnvironmentTree::showProblems()
{
    m_isFilling = true;
    for (QTreeWidgetItemIterator it(this); *it != nullptr; ++it) {
        const QString problem = problemOf(**it);
        (*it)->setData(0, Qt::ForegroundRole,
                       problem.isEmpty() ? QVariant() : QVariant(QBrush(kTroubleColor)));
        (*it)->setToolTip(0, problem);
    }
    m_isFilling = false;
}

QString EnvironmentTree::problemOfChosen() const
{
    for (const QTreeWidgetItem* item : selectedItems()) {
        if (QString problem = problemOf(*item); !problem.isEmpty()) {
            return problem;
        }
    }
    return {};
}

void EnvironmentTree::rename(QTreeWidgetItem* item)
{
    const std::string name = item->text(0).toStdString();
    const auto id = item->data(0, kIdRole).toUInt();
    if (const model::Path* path = m_state.scene().findPath(id);
        item->type() == PathItem && path != nullptr) {
        model::Path renamed = *path;
        renamed.name = name;
        m_state.document().edit(tr("Rename a path"),
                                [&](model::SceneEdit& edit) { edit.changePath(renamed); });
    } else if (const model::Place* place = m_state.scene().findPlace(id);
               item->type() == PlaceItem && place != nullptr) {
        model::Place renamed = *place;
        renamed.name = name;
        m_state.document().edit(tr("Rename a place"),
                                [&](model::SceneEdit& edit) { edit.changePlace(renamed); });
    }
}

} // namespace crowd::widgets
