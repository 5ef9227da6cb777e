// SPDX-License-Identifier: MIT
#include <QtWidgets/QMenu>
#include <QtWidgets/QTreeWidget>

#include "model/document/PathEdits.h"
#include "model/document/SceneEdit.h"
#include "widgets/docks/EnvironmentDock.h"

/// What can be done to a path or a place of the tree, in its menu.
namespace crowd::widgets {

void EnvironmentDock::assignSelected(model::PathId id)
{
    const std::vector<model::IndividualId> ids(m_state.selection().ids().begin(),
                                               m_state.selection().ids().end());
    if (m_state.document().isEditOpen()) {
        return; // in the middle of a stroke
    }
    if (ids.empty()) {
        m_state.showStatus(tr("Nobody is selected: select characters first (V), or paint them with "
                              "the walk brush (W)."));
        return;
    }
    auto edit = m_state.document().beginEdit();
    edit->setColumn(model::columns::path, ids, std::span<const model::PathId>(&id, 1));
    edit->commit(tr("Let %n character(s) walk", nullptr, static_cast<int>(ids.size())));
}

void EnvironmentDock::selectPeopleOf(model::PathId id)
{
    std::vector<model::IndividualId> ids;
    const model::Population& people = m_state.scene().population;
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (people.column(model::columns::path)[row] == id) {
            ids.push_back(people.ids()[row]);
        }
    }
    m_state.selection().set(ids);
}

void EnvironmentDock::showMenu(const QPoint& position)
{
    QTreeWidgetItem* item = m_tree->itemAt(position);
    if (item == nullptr || m_state.document().isEditOpen()) {
        return;
    }
    QMenu menu(this);
    if (item->type() == PathItem) {
        fillPathMenu(menu, item->data(0, kIdRole).toUInt());
    } else if (item->type() == PlaceItem) {
        fillPlaceMenu(menu, item);
    }
    menu.exec(m_tree->viewport()->mapToGlobal(position));
}

void EnvironmentDock::fillPathMenu(QMenu& menu, model::PathId id)
{
    const auto act = [this, &menu](const QString& text, const QString& undoText,
                                   const std::function<void(model::SceneEdit&)>& change) {
        connect(menu.addAction(text), &QAction::triggered, this, [this, undoText, change] {
            auto edit = m_state.document().beginEdit();
            change(*edit);
            edit->commit(undoText);
        });
    };
    connect(menu.addAction(tr("Go On Painting It")), &QAction::triggered, this, [this, id] {
        m_state.setTool(ToolId::BrushPath);
        m_state.paths().paint(id);
    });
    act(tr("Reverse"), tr("Reverse a path"),
        [id](model::SceneEdit& edit) { model::reversePath(edit, id); });
    QMenu* join = menu.addMenu(tr("Join with"));
    for (const model::Path& other : m_state.scene().paths) {
        if (other.id != id) {
            connect(join->addAction(QString::fromStdString(other.name)), &QAction::triggered, this,
                    [this, id, second = other.id] {
                        auto edit = m_state.document().beginEdit();
                        model::joinPaths(*edit, id, second);
                        edit->commit(tr("Join two paths"));
                    });
        }
    }
    join->setEnabled(!join->isEmpty());
    menu.addSeparator();
    connect(menu.addAction(tr("Let the Selected Characters Walk It")), &QAction::triggered, this,
            [this, id] { assignSelected(id); });
    connect(menu.addAction(tr("Select Its Characters")), &QAction::triggered, this,
            [this, id] { selectPeopleOf(id); });
    menu.addSeparator();
    act(tr("Delete the Path"), tr("Delete a path"),
        [id](model::SceneEdit& edit) { edit.removePath(id); });
    act(tr("Delete It with Its Places"), tr("Delete a path"), [id](model::SceneEdit& edit) {
        const std::vector<model::PlaceId> places = edit.scene().findPath(id)->places;
        edit.removePath(id);
        for (const model::PlaceId each : places) {
            if (edit.scene().findPlace(each) != nullptr) {
                edit.removePlace(each);
            }
        }
    });
}

void EnvironmentDock::fillPlaceMenu(QMenu& menu, QTreeWidgetItem* item)
{
    const auto id = item->data(0, kIdRole).toUInt();
    if (item->parent()->type() == PathItem) {
        const auto pathId = item->parent()->data(0, kIdRole).toUInt();
        const int index = item->data(0, kIndexRole).toInt();
        connect(menu.addAction(tr("Insert a Place After It")), &QAction::triggered, this,
                [this, pathId, index] {
                    const model::Path& inPath = *m_state.scene().findPath(pathId);
                    const auto at = static_cast<std::size_t>(index);
                    const std::size_t next = (at + 1) % inPath.places.size();
                    model::Place added = *m_state.scene().findPlace(inPath.places[at]);
                    const model::Place& other = *m_state.scene().findPlace(inPath.places[next]);
                    added.position = (added.position + other.position) * 0.5F;
                    added.name.clear();
                    auto edit = m_state.document().beginEdit();
                    const model::PlaceId made = model::insertPlace(*edit, pathId, at + 1, added);
                    edit->commit(tr("Insert a place"));
                    m_state.paths().select({made});
                });
        connect(menu.addAction(tr("Take It Out of the Path")), &QAction::triggered, this,
                [this, pathId, index] {
                    model::Path shorter = *m_state.scene().findPath(pathId);
                    shorter.places.erase(shorter.places.begin() + index);
                    auto edit = m_state.document().beginEdit();
                    edit->changePath(shorter);
                    edit->commit(tr("Take a place out of a path"));
                });
    }
    connect(menu.addAction(tr("Delete the Place")), &QAction::triggered, this, [this, id] {
        auto edit = m_state.document().beginEdit();
        edit->removePlace(id);
        edit->commit(tr("Delete %n place(s)", nullptr, 1));
    });
}

} // namespace crowd::widgets
