// SPDX-License-Identifier: MIT
#include "widgets/docks/BranchList.h"

#include <algorithm>

#include <QtCore/QTimer>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/document/SceneEdit.h"
#include "widgets/forms/WrapRow.h"
#include "widgets/rules/RuleFields.h"

namespace crowd::widgets {

namespace {

constexpr double kMostWeight = 1000.0;

} // namespace

BranchList::BranchList(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
}

void BranchList::setPath(model::PathId path)
{
    m_path = path;
    // After the field that may just be telling of a change has had its say.
    QTimer::singleShot(0, this, &BranchList::rebuild);
}

std::vector<const model::Path*> BranchList::others() const
{
    std::vector<const model::Path*> paths;
    for (const model::Path& path : m_state.scene().paths) {
        if (path.id != m_path && !path.places.empty()) {
            paths.push_back(&path);
        }
    }
    return paths;
}

void BranchList::rebuild()
{
    delete m_rows;
    m_rows = nullptr;
    const model::Path* path = m_state.scene().findPath(m_path);
    if (path == nullptr || path->places.empty()) {
        return;
    }
    m_rows = new QWidget(this);
    auto* rows = new QVBoxLayout(m_rows);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(3);
    if (!path->branches.empty()) {
        rows->addWidget(new QLabel(tr("Some leave it:"), m_rows));
    }
    for (std::size_t i = 0; i < path->branches.size(); ++i) {
        addRow(*path, i);
    }
    auto* add = new QToolButton(m_rows);
    add->setObjectName(QStringLiteral("addBranch"));
    add->setText(tr("+ branch to another path"));
    add->setToolTip(others().empty()
                        ? tr("There is no other path yet")
                        : tr("Let some characters go over to another path at a place"));
    add->setEnabled(!others().empty());
    add->setAutoRaise(true);
    rows->addWidget(add);
    connect(add, &QToolButton::clicked, this, &BranchList::addBranch);
    layout()->addWidget(m_rows);
}

void BranchList::addPlaces(QHBoxLayout* row, const model::Path& path, std::size_t index)
{
    std::vector<model::PlaceId> ids;
    QStringList names;
    for (const model::PlaceId id : path.places) {
        const model::Place* place = m_state.scene().findPlace(id);
        if (place != nullptr && std::ranges::find(ids, id) == ids.end()) {
            ids.push_back(id);
            names << tr("at %1").arg(QString::fromStdString(place->name));
        }
    }
    const auto now = std::ranges::find(ids, path.branches[index].place);
    addChoiceField(row, names, now == ids.end() ? -1 : static_cast<int>(now - ids.begin()),
                   [this, ids, index](int choice) {
                       change(tr("Change a branch"), [&](model::Path& each) {
                           each.branches[index].place = ids[static_cast<std::size_t>(choice)];
                       });
                   });
}

void BranchList::addPaths(QHBoxLayout* row, const model::Path& path, std::size_t index)
{
    std::vector<model::PathId> ids;
    QStringList names;
    for (const model::Path* other : others()) {
        ids.push_back(other->id);
        names << tr("to %1").arg(QString::fromStdString(other->name));
    }
    const auto now = std::ranges::find(ids, path.branches[index].path);
    addChoiceField(row, names, now == ids.end() ? -1 : static_cast<int>(now - ids.begin()),
                   [this, ids, index](int choice) {
                       change(tr("Change a branch"), [&](model::Path& each) {
                           each.branches[index].path = ids[static_cast<std::size_t>(choice)];
                       });
                   });
}

void BranchList::addRow(const model::Path& path, std::size_t index)
{
    auto* rows = static_cast<QVBoxLayout*>(m_rows->layout());
    const auto addLine = [rows] {
        auto* line = new WrapRow;
        line->setSpacing(4);
        rows->addLayout(line);
        return line;
    };
    // A line for each name: beside each other neither could be read.
    QHBoxLayout* where = addLine();
    addPlaces(where, path, index);
    addRemoveButton(where, tr("Remove this branch"), [this, index] {
        change(tr("Remove a branch"), [&](model::Path& each) {
            each.branches.erase(each.branches.begin() + static_cast<std::ptrdiff_t>(index));
        });
    });
    QHBoxLayout* whither = addLine();
    addPaths(whither, path, index);
    whither->setStretch(0, 2);
    addNumberField(whither, static_cast<double>(path.branches[index].weight), 0.0, kMostWeight,
                   tr(" × as often"), [this, index](double weight) {
                       change(tr("Change the weight of a branch"), [&](model::Path& each) {
                           each.branches[index].weight = static_cast<float>(weight);
                       });
                   });
    whither->itemAt(1)->widget()->setToolTip(
        tr("So many go over for each one who goes on: at 1, half of them"));
}

void BranchList::addBranch()
{
    const std::vector<const model::Path*> targets = others();
    const model::Path* path = m_state.scene().findPath(m_path);
    if (targets.empty() || path == nullptr || path->places.empty()) {
        return;
    }
    // At the place that is nearest to where another path begins.
    model::PathBranch made{path->places.front(), targets.front()->id, 1.0F};
    float nearest = -1.0F;
    for (const model::Path* other : targets) {
        const model::Place* begin = m_state.scene().findPlace(other->places.front());
        for (const model::PlaceId id : path->places) {
            const model::Place* place = m_state.scene().findPlace(id);
            if (begin == nullptr || place == nullptr) {
                continue;
            }
            const float away = glm::distance(begin->position, place->position);
            if (nearest < 0.0F || away < nearest) {
                nearest = away;
                made.place = id;
                made.path = other->id;
            }
        }
    }
    change(tr("Add a branch"), [&](model::Path& each) { each.branches.push_back(made); });
}

void BranchList::change(const QString& undoText, const std::function<void(model::Path&)>& apply)
{
    const model::Path* path = m_state.scene().findPath(m_path);
    if (path == nullptr) {
        return;
    }
    model::Path changed = *path;
    apply(changed);
    m_state.document().edit(undoText, [&](model::SceneEdit& edit) { edit.changePath(changed); });
}

} // namespace crowd::widgets
