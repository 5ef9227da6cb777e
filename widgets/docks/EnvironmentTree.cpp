// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include <QtCore/QLocale>
#include <QtGui/QPainter>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QTreeWidget>

#include "model/base/Translated.h"
#include "model/document/SceneEdit.h"
#include "widgets/docks/EnvironmentDock.h"
#include "widgets/docks/EnvironmentMenu.h"

/// Paths and places as a tree: what is in it, what is selected in it, and how many people are
/// where.
namespace crowd::widgets {

namespace {

constexpr int kUnfoldedPlaces = 8; ///< longer paths are folded at first
constexpr int kTallyMs = 300;

} // namespace

QIcon EnvironmentDock::colorIcon(const std::array<std::uint8_t, 3>& color)
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

void EnvironmentDock::followSession()
{
    m_count.setSingleShot(true);
    m_count.setInterval(kTallyMs);
    SessionControl& session = m_state.session();
    connect(&m_count, &QTimer::timeout, this, [this, &session] {
        m_countedSeconds = session.availableSeconds();
        session.askTally();
    });
    connect(&session, &SessionControl::stateChanged, this, &EnvironmentDock::showCounts);
    connect(&session, &SessionControl::stepped, this, [this, &session] {
        if (session.tally() != m_tally) {
            showCounts();
        }
        const bool isAnother = session.availableSeconds() != m_countedSeconds;
        if (isAnother && m_tree->isVisible() && !m_count.isActive()) {
            m_count.start();
        }
    });
}

void EnvironmentDock::rebuild()
{
    if (m_tree->viewport()->findChild<QLineEdit*>() != nullptr) {
        m_rebuild.start(); // not under the hands of who renames
        return;
    }
    m_countedSeconds = -1.0; // people may have been given other paths
    std::map<model::PathId, bool> isOpen;
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        const QTreeWidgetItem& item = *m_tree->topLevelItem(i);
        isOpen[item.data(0, kIdRole).toUInt()] = item.isExpanded();
    }
    const int scrolled = m_tree->verticalScrollBar()->value();
    m_isFilling = true;
    m_tree->clear();
    addPaths();
    addPlaces();
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem& item = *m_tree->topLevelItem(i);
        const auto known = isOpen.find(item.data(0, kIdRole).toUInt());
        item.setExpanded(known != isOpen.end()
                             ? known->second
                             : item.childCount() <= kUnfoldedPlaces || item.type() == KindItem);
    }
    m_isFilling = false;
    const bool isEmpty = m_state.scene().places.empty() && m_state.scene().paths.empty();
    m_note->setVisible(isEmpty);
    m_tree->setVisible(!isEmpty); // else the note would stand below an empty list
    m_tree->verticalScrollBar()->setValue(scrolled);
    showCounts();
    showSelection();
}

void EnvironmentDock::addPaths()
{
    const model::Scene& scene = m_state.scene();
    for (const model::Path& each : scene.paths) {
        auto* item = new QTreeWidgetItem(m_tree, {QString::fromStdString(each.name)}, PathItem);
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
void EnvironmentDock::addPlaces()
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
            heading = new QTreeWidgetItem(m_tree, {tr("Places")}, KindItem);
        }
        addPlace(*heading, each)->setIcon(0, colorIcon(each.color));
    }
}

QTreeWidgetItem* EnvironmentDock::addPlace(QTreeWidgetItem& parent, const model::Place& place)
{
    auto* item = new QTreeWidgetItem(&parent, {QString::fromStdString(place.name)}, PlaceItem);
    item->setData(0, kIdRole, place.id);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    return item;
}

/// Of the run, while there is one; else of the scene, which says nothing of places.
behavior::SessionTally EnvironmentDock::tally() const
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

void EnvironmentDock::showCounts()
{
    m_tally = tally();
    const auto countIn = [](const auto& counts, std::uint32_t id) {
        const auto found = counts.find(id);
        return found == counts.end() ? 0 : static_cast<int>(found->second);
    };
    m_isFilling = true;
    for (QTreeWidgetItemIterator it(m_tree); *it != nullptr; ++it) {
        const auto id = (*it)->data(0, kIdRole).toUInt();
        if ((*it)->type() == PathItem) {
            (*it)->setText(1, tr("%n characters", nullptr, countIn(m_tally.followers, id)));
        } else if (const model::Place* place = m_state.scene().findPlace(id)) {
            const QString radius = QLocale().toString(static_cast<double>(place->radius), 'f', 2);
            const int inside = countIn(m_tally.inside, id);
            (*it)->setText(1, inside > 0 ? tr("%n in it · %1 m", nullptr, inside).arg(radius)
                                         : tr("%1 m").arg(radius));
        }
    }
    m_isFilling = false;
}

void EnvironmentDock::showSelection()
{
    m_isFilling = true;
    for (QTreeWidgetItemIterator it(m_tree); *it != nullptr; ++it) {
        const auto id = (*it)->data(0, kIdRole).toUInt();
        const bool isPlace = (*it)->type() == PlaceItem;
        const bool isPath = (*it)->type() == PathItem && m_state.paths().places().empty();
        (*it)->setSelected((isPlace && m_state.paths().isSelected(id)) ||
                           (isPath && id != 0 && id == m_state.paths().path()));
    }
    m_isFilling = false;
    refreshForm();
    showProblems();
    m_scroll.start();
}

/// Once for each choice, and for each place that a chosen path grows by: who scrolls on is left
/// alone.
void EnvironmentDock::scrollToSelection()
{
    QTreeWidgetItem* last = nullptr;
    const PathFocus& focus = m_state.paths();
    for (QTreeWidgetItem* item : m_tree->selectedItems()) {
        const bool isLast = item->type() == PathItem || focus.places().empty() ||
                            item->data(0, kIdRole).toUInt() == focus.places().back();
        const bool isInPath =
            item->parent() != nullptr && item->parent()->data(0, kIdRole).toUInt() == focus.path();
        last = last == nullptr || (isLast && isInPath) ? item : last;
    }
    const int length = last != nullptr && last->type() == PathItem ? last->childCount() : 0;
    const Shown shown{focus.path(), focus.places(), length};
    if (last == nullptr || shown == m_shown || !m_tree->isVisible()) {
        return;
    }
    const bool isLonger = shown.path == m_shown.path && length > m_shown.length;
    m_shown = shown;
    if (isLonger && focus.isPainting()) {
        m_tree->scrollToItem(last->child(length - 1));
    }
    m_tree->scrollToItem(last);
}

void EnvironmentDock::showMenu(const QPoint& position)
{
    const QTreeWidgetItem* item = m_tree->itemAt(position);
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
    menu.exec(m_tree->viewport()->mapToGlobal(position));
}

void EnvironmentDock::takeSelection()
{
    if (m_isFilling) {
        return;
    }
    std::vector<model::PlaceId> places;
    model::PathId chosen = m_state.paths().path();
    for (QTreeWidgetItem* item : m_tree->selectedItems()) {
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
QString EnvironmentDock::problemOf(const QTreeWidgetItem& item) const
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

/// At the paths and places, and above the form for the one that is chosen.
void EnvironmentDock::showProblems()
{
    m_isFilling = true;
    QString chosen;
    for (QTreeWidgetItemIterator it(m_tree); *it != nullptr; ++it) {
        const QString problem = problemOf(**it);
        (*it)->setData(0, Qt::ForegroundRole,
                       problem.isEmpty() ? QVariant() : QVariant(QBrush(kTroubleColor)));
        (*it)->setToolTip(0, problem);
        chosen = chosen.isEmpty() && (*it)->isSelected() ? problem : chosen;
    }
    m_isFilling = false;
    // Of people; a click selects them.
    const std::vector<behavior::Problem>& problems = m_state.session().problems();
    const auto ofPeople = std::ranges::find_if(
        problems, [](const behavior::Problem& problem) { return !problem.people.empty(); });
    if (chosen.isEmpty() && ofPeople != problems.end()) {
        chosen = tr("%1 <a href=\"people\">Select them</a>")
                     .arg(model::translated(ofPeople->text).toHtmlEscaped());
    }
    m_problem->setText(chosen);
    m_problem->setVisible(!chosen.isEmpty());
}

void EnvironmentDock::selectTroubled()
{
    for (const behavior::Problem& problem : m_state.session().problems()) {
        if (!problem.people.empty()) {
            m_state.selection().set(problem.people);
            return;
        }
    }
}

} // namespace crowd::widgets
