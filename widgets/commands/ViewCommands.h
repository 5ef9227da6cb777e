// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "model/base/Bounds.h"
#include "widgets/commands/CameraMoves.h"
#include "widgets/state/EditorState.h"

/// What menus and keys do with the view. Bookmarks are part of the scene: undoable edits; moving
/// the view is not.
namespace crowd::widgets {

/// The box around all people, with room for their bodies, all places, and what the stages are made
/// of for the most part: hills on the horizon stay outside. Of an empty scene, some of its ground.
[[nodiscard]] model::Bounds sceneBounds(const model::Scene& scene);
/// The box around the selected people and places; empty when nothing is selected.
[[nodiscard]] model::Bounds selectionBounds(const EditorState& state);

/// Smoothly shows the selected people and places; everything when nothing is selected.
void frameSelection(EditorState& state);
/// Shows the chosen lamp; nothing where none is chosen.
void frameLight(EditorState& state);
void frameAll(EditorState& state);
void lookFrom(EditorState& state, ViewDirection direction);
void toggleProjection(EditorState& state);

/// Smoothly goes to a bookmark of the scene; says so when there is none of that name. A mark of the
/// timeline where that is recorded.
void goToCamera(EditorState& state, const QString& name);
/// That no camera of the scene has yet: the wanted one, or one like it.
[[nodiscard]] QString freeCameraName(const EditorState& state, const QString& wanted);
/// Keeps the view under a name that is not taken yet ("View 3" if empty) and returns it.
QString addCamera(EditorState& state, const QString& name = {});
/// What the view looks like from there; 0: as it does elsewhere.
void setCameraLook(EditorState& state, const QString& name, model::LookId look);
/// Puts the present view into an existing bookmark.
void updateCamera(EditorState& state, const QString& name);
void removeCamera(EditorState& state, const QString& name);
/// False when the new name is empty or taken.
bool renameCamera(EditorState& state, const QString& from, const QString& to);

} // namespace crowd::widgets
