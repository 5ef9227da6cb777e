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
    if (state.document().isEditOpen()) {
        return; // in the middle of a stroke
    }
    // A copy: the selection drops the ids while they go.
    const std::vector<model::IndividualId> ids(state.selection().ids().begin(),
                                               state.selection().ids().end());
    const std::vector<model::PlaceId> places = state.paths().places();
    if (!places.empty()) {
        auto edit = state.document().beginEdit();
        for (const model::PlaceId place : places) {
            edit->removePlace(place);
        }
        edit->removeIndividuals(ids);
        edit->commit(SelectionCommandsText::tr("Delete %n place(s)", nullptr,
                                               static_cast<int>(places.size())));
        return;
    }
    if (ids.empty()) {
        state.showStatus(
            SelectionCommandsText::tr("Nobody is selected: there is nobody to delete."));
        return;
    }
    auto edit = state.document().beginEdit();
    edit->removeIndividuals(ids);
    edit->commit(
        SelectionCommandsText::tr("Delete %n character(s)", nullptr, static_cast<int>(ids.size())));
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
    if (state.document().isEditOpen()) {
        return;
    }
    const auto chosen = state.selection().ids();
    const auto everybody = state.scene().population.ids();
    std::vector<model::IndividualId> ids(chosen.begin(), chosen.end());
    if (ids.empty()) {
        ids.assign(everybody.begin(), everybody.end());
    }
    const model::WalkableGroundPtr ground = state.ground().wait();
    int moved = 0;
    if (ground) {
        auto edit = state.document().beginEdit();
        moved = model::putOnGround(*edit, *ground, ids);
        edit->commit(
            SelectionCommandsText::tr("Put %n character(s) on the ground", nullptr, moved));
    }
    state.showStatus(
        moved > 0 ? SelectionCommandsText::tr("%n characters put on the ground", nullptr, moved)
                  : SelectionCommandsText::tr("All of them stand where characters can walk."));
}

} // namespace crowd::widgets
