// SPDX-License-Identifier: MIT
#include "widgets/commands/SelectionCommands.h"

#include <vector>

#include <QtCore/QCoreApplication>

#include "model/document/GroundEdits.h"
#include "model/document/SceneEdit.h"
#include "model/population/Neighbours.h"

namespace crowd::widgets {

namespace {

constexpr float kBeside = 1.5F; ///< metres: the next seat, the next row

struct SelectionCommandsText
{
    Q_DECLARE_TR_FUNCTIONS(SelectionCommands)
};

} // namespace

void deleteSelection(EditorState& state)
{
    // A copy: the selection drops the ids while they go.
    const std::vector<model::IndividualId> ids(state.selection().ids().begin(),
                                               state.selection().ids().end());
    const std::vector<model::PlaceId> places = state.paths().places();
    if (!places.empty()) {
        const QString text = SelectionCommandsText::tr("Delete %n place(s)", nullptr,
                                                       static_cast<int>(places.size()));
        state.document().edit(text, [&](model::SceneEdit& edit) {
            for (const model::PlaceId place : places) {
                edit.removePlace(place);
            }
            edit.removeIndividuals(ids);
        });
        return;
    }
    if (ids.empty()) {
        state.showStatus(
            SelectionCommandsText::tr("Nobody is selected: there is nobody to delete."));
        return;
    }
    const QString text =
        SelectionCommandsText::tr("Delete %n character(s)", nullptr, static_cast<int>(ids.size()));
    state.document().edit(text, [&](model::SceneEdit& edit) { edit.removeIndividuals(ids); });
}

void selectSimilar(EditorState& state)
{
    state.selection().set(model::lookAlikes(state.scene().population, state.selection().ids()));
}

void growSelection(EditorState& state)
{
    state.selection().set(
        model::withNeighbours(state.scene().population, state.selection().ids(), kBeside));
}

void shrinkSelection(EditorState& state)
{
    state.selection().set(
        model::withoutRim(state.scene().population, state.selection().ids(), kBeside));
}

void putSelectionOnGround(EditorState& state)
{
    const auto chosen = state.selection().ids();
    const auto everybody = state.scene().population.ids();
    std::vector<model::IndividualId> ids(chosen.begin(), chosen.end());
    if (ids.empty()) {
        ids.assign(everybody.begin(), everybody.end());
    }
    const model::WalkableGroundPtr ground = state.ground().wait();
    int moved = 0;
    if (ground) {
        const auto outcome = state.document().edit([&](model::SceneEdit& edit) {
            moved = model::putOnGround(edit, *ground, ids);
            return SelectionCommandsText::tr("Put %n character(s) on the ground", nullptr, moved);
        });
        if (outcome == model::EditOutcome::Refused) {
            return;
        }
    }
    state.showStatus(
        moved > 0 ? SelectionCommandsText::tr("%n characters put on the ground", nullptr, moved)
                  : SelectionCommandsText::tr("All of them stand where characters can walk."));
}

} // namespace crowd::widgets
