// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include <QtCore/QString>

#include "model/base/Result.h"
#include "model/scene/LookPreset.h"
#include "widgets/state/EditorState.h"

/// What panel and menu do with the looks of a scene: one undo step each.
namespace crowd::widgets {

/// Those that can be added, by an English name that is translated in the context "Looks".
[[nodiscard]] std::span<const model::LookPreset> readyLooks();
/// The view as it is, as a look of the scene.
[[nodiscard]] model::LookPreset lookOfView(const EditorState& state);
/// With an id and a name of its own behind the others, and shown. Its id; 0: there is no room, or
/// nothing can be edited now.
model::LookId addLook(EditorState& state, model::LookPreset look, const QString& name);
void removeLook(EditorState& state, model::LookId id);
/// False, with a word in the status line: names are not empty, and of one look each.
bool renameLook(EditorState& state, model::LookId id, const QString& name);
void moveLook(EditorState& state, model::LookId id, int by); ///< rows down
/// The looks with one of them changed.
[[nodiscard]] model::Looks withLook(const model::Looks& looks, model::LookId id,
                                    const std::function<void(model::LookPreset&)>& apply);

[[nodiscard]] model::Result<void> exportLook(const EditorState& state, model::LookId id,
                                             const QString& path);
[[nodiscard]] model::Result<void> importLooks(EditorState& state, const QString& path);

} // namespace crowd::widgets
