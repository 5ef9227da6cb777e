// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QString>

#include "model/document/GroupEdits.h"
#include "widgets/state/EditorState.h"

/// What panels and menus do with groups: one undo step each, nothing while a stroke is open.
namespace crowd::widgets {

/// Of the create brush: new characters come into it. 0: none.
[[nodiscard]] model::GroupId activeGroup(const EditorState& state);
/// Also what the group brush paints.
void setActiveGroup(EditorState& state, model::GroupId group);

/// A new group of those who are selected, if any; it becomes the active one.
void groupSelection(EditorState& state);
/// Where there are no groups and the group brush has none: makes one for it.
void makeFirstGroup(EditorState& state);
/// Takes the selected ones into a group; 0: out of theirs. Says so where nobody is selected.
void putSelectionInGroup(EditorState& state, model::GroupId group);
void selectGroup(EditorState& state, model::GroupId group);
void deleteGroup(EditorState& state, model::GroupId group);
void showGroupAlone(EditorState& state, model::GroupId group);
void editGroups(EditorState& state, const QString& undoText,
                const std::function<void(model::SceneEdit&)>& apply);

} // namespace crowd::widgets
