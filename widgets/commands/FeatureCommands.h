// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QString>

#include "model/scene/Feature.h"
#include "widgets/state/EditorState.h"

/// What panels and menus do with features: one undo step each, nothing while something else is
/// edited. They say in the status bar what came of it.
namespace crowd::widgets {

/// Whether there can be one more.
[[nodiscard]] bool hasRoomForKind(EditorState& state);
/// "Feature 3": one that no kind has.
[[nodiscard]] QString freeKindName(const EditorState& state);
/// The new one's id; 0: there are as many as there can be, or the name is not sound.
std::uint8_t addKind(EditorState& state, const QString& name);
void removeKind(EditorState& state, std::uint8_t kind);
/// Whether it has that name now.
bool renameKind(EditorState& state, std::uint8_t kind, const QString& name);

/// At the end of its kind; the new one's id, 0: none.
model::FeatureId addFeature(EditorState& state, std::uint8_t kind);
/// A copy behind it.
model::FeatureId duplicateFeature(EditorState& state, model::FeatureId id);
void removeFeature(EditorState& state, model::FeatureId id);
bool renameFeature(EditorState& state, model::FeatureId id, const QString& name);
/// So many places further.
void moveFeature(EditorState& state, model::FeatureId id, int by);
/// The value in place of the one of its id. `isWorn`: its bearers change with it.
void changeFeature(EditorState& state, const model::FeatureValue& value, bool isWorn);
/// Whoever is selected bears it from now on; all where nobody is.
void giveFeature(EditorState& state, model::FeatureId id);
/// Whoever is selected bears none of the kind any more.
void takeFeatureOff(EditorState& state, std::uint8_t kind);
/// The brush that paints it is in hand from now on.
void paintFeature(EditorState& state, model::FeatureId id);
void selectBearers(EditorState& state, model::FeatureId id);

/// A kind with its values as a file that other scenes take in: Result's error says what is wrong.
[[nodiscard]] model::Result<void> exportKind(const EditorState& state, std::uint8_t kind,
                                             const QString& path);
/// Kinds of a file come to those of the scene; one of the same name gets its values: those of the
/// same name are replaced, others come behind.
[[nodiscard]] model::Result<void> importKinds(EditorState& state, const QString& path);

} // namespace crowd::widgets
