// SPDX-License-Identifier: MIT
#include "widgets/docks/EnvironmentMenu.h"

#include "model/document/PathEdits.h"
#include "model/document/SceneEdit.h"

namespace crowd::widgets {

namespace {

void removeWithPlaces(model::SceneEdit& edit, model::PathId id)
{
    const std::vector<model::PlaceId> places = edit.scene().findPath(id)->places;
    edit.removePath(id);
    for (const model::PlaceId each : places) {
        if (edit.scene().findPlace(each) != nullptr) {
            edit.removePlace(each);
        }
    }
}

} // namespace

EnvironmentMenu::EnvironmentMenu(EditorState& state, QWidget* parent)
    : QMenu(parent), m_state(state)
{
    connect(&state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (std::holds_alternative<model::PathsChanged>(change) ||
                    std::holds_alternative<model::SceneReplaced>(change)) {
                    close();
                }
            });
}

void EnvironmentMenu::addChange(const QString& text, const QString& undoText, const Change& change)
{
    connect(addAction(text), &QAction::triggered, this, [this, undoText, change] {
        m_state.document().edit(undoText, [&](model::SceneEdit& edit) { change(edit); });
    });
}

void EnvironmentMenu::fillForPath(model::PathId id)
{
    connect(addAction(tr("Go On Painting It")), &QAction::triggered, this, [this, id] {
        m_state.setTool(ToolId::BrushPath);
        m_state.paths().paint(id);
    });
    addChange(tr("Reverse"), tr("Reverse a path"),
              [id](model::SceneEdit& edit) { model::reversePath(edit, id); });
    addJoining(id);
    addSeparator();
    addPeople(id);
    addSeparator();
    addChange(tr("Delete the Path"), tr("Delete a path"),
              [id](model::SceneEdit& edit) { edit.removePath(id); });
    addChange(tr("Delete It with Its Places"), tr("Delete a path"),
              [id](model::SceneEdit& edit) { removeWithPlaces(edit, id); });
}

void EnvironmentMenu::addJoining(model::PathId id)
{
    QMenu* join = addMenu(tr("Join with"));
    for (const model::Path& other : m_state.scene().paths) {
        if (other.id == id) {
            continue;
        }
        connect(join->addAction(QString::fromStdString(other.name)), &QAction::triggered, this,
                [this, id, second = other.id] {
                    m_state.document().edit(tr("Join two paths"), [&](model::SceneEdit& edit) {
                        model::joinPaths(edit, id, second);
                    });
                });
    }
    join->setEnabled(!join->isEmpty());
}

void EnvironmentMenu::addPeople(model::PathId id)
{
    connect(addAction(tr("Let the Selected Characters Walk It")), &QAction::triggered, this,
            [this, id] { assignSelected(id); });
    connect(addAction(tr("Select Its Characters")), &QAction::triggered, this,
            [this, id] { selectPeopleOf(id); });
}

void EnvironmentMenu::fillForPlace(model::PlaceId id, const std::optional<Stop>& stop)
{
    if (stop) {
        connect(addAction(tr("Insert a Place After It")), &QAction::triggered, this,
                [this, at = *stop] { insertAfter(at); });
        connect(addAction(tr("Take It Out of the Path")), &QAction::triggered, this,
                [this, at = *stop] { takeOut(at); });
    }
    addChange(tr("Delete the Place"), tr("Delete %n place(s)", nullptr, 1),
              [id](model::SceneEdit& edit) { edit.removePlace(id); });
}

/// Half way to the next one.
void EnvironmentMenu::insertAfter(const Stop& stop)
{
    const model::Path& path = *m_state.scene().findPath(stop.path);
    const std::size_t next = (stop.index + 1) % path.places.size();
    model::Place added = *m_state.scene().findPlace(path.places[stop.index]);
    const model::Place& other = *m_state.scene().findPlace(path.places[next]);
    added.position = (added.position + other.position) * 0.5F;
    added.name.clear();
    m_state.document().edit(tr("Insert a place"), [&](model::SceneEdit& edit) {
        m_state.paths().select({model::insertPlace(edit, stop.path, stop.index + 1, added)});
    });
}

void EnvironmentMenu::takeOut(const Stop& stop)
{
    model::Path shorter = *m_state.scene().findPath(stop.path);
    shorter.places.erase(shorter.places.begin() + static_cast<std::ptrdiff_t>(stop.index));
    m_state.document().edit(tr("Take a place out of a path"),
                            [&](model::SceneEdit& edit) { edit.changePath(shorter); });
}

void EnvironmentMenu::assignSelected(model::PathId id)
{
    const std::vector<model::IndividualId> ids(m_state.selection().ids().begin(),
                                               m_state.selection().ids().end());
    if (ids.empty()) {
        m_state.showStatus(tr("Nobody is selected: select characters first (V), or paint them with "
                              "the walk brush (W)."));
        return;
    }
    m_state.document().edit(tr("Let %n character(s) walk", nullptr, static_cast<int>(ids.size())),
                            [&](model::SceneEdit& edit) {
                                edit.setColumn(model::columns::path, ids,
                                               std::span<const model::PathId>(&id, 1));
                            });
}

void EnvironmentMenu::selectPeopleOf(model::PathId id)
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

} // namespace crowd::widgets
