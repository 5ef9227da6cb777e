// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/state/EditorState.h"

/// Kinds of relations, and relations of those who are selected. Each is one undo step, or none and
/// a remark why.
namespace crowd::widgets {

/// With a name of its own; 0: there are as many as there can be.
model::RelationKindId addRelationKind(EditorState& state);
/// Its relations go with it.
void removeRelationKind(EditorState& state, model::RelationKindId kind);
/// False where the name is none, or taken.
bool renameRelationKind(EditorState& state, model::RelationKindId kind, const QString& name);
void changeRelationKind(EditorState& state, const model::RelationKind& kind);

/// Each of the selected with each; of one that is not mutual, from the oldest to the others.
void relateSelected(EditorState& state, model::RelationKindId kind);
/// All relations of a kind that the selected have.
void unrelateSelected(EditorState& state, model::RelationKindId kind);
/// Everybody who has a relation of the kind.
void selectThoseRelated(EditorState& state, model::RelationKindId kind);
/// Also those who are related to one of the selected, by a kind or by any (0).
void growSelectionToRelated(EditorState& state, model::RelationKindId kind);
/// Copies of the selected beside them, with the relations among them; they are selected then.
void duplicateSelection(EditorState& state);

} // namespace crowd::widgets
