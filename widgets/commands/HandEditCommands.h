// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <QtCore/QString>

#include "model/scene/HandEdit.h"
#include "model/scene/Take.h"
#include "widgets/state/EditorState.h"

/// What is done by hand to the people of the take that is shown. Each is one undo step. Main
/// thread.
namespace crowd::widgets {

/// What an artist adds by name.
enum class HandEditWish { Later, Slower, Still, Aside, Hidden, Swapped };

/// For the selected people: from the moment shown, or within the play range where there is one.
/// False: no take is shown, nobody is selected, or there is no room for more, which is said.
bool addHandEdit(EditorState& state, HandEditWish wish);
/// As the list of edits becomes of the take that is shown; nothing where that has changed.
[[nodiscard]] model::Takes withEdits(const EditorState& state,
                                     const std::function<void(model::Take& take)>& change);
void setHandEditOn(EditorState& state, std::size_t edit, bool isOn);
void setHandEditsOn(EditorState& state, bool areOn);
void removeHandEdit(EditorState& state, std::size_t edit);
/// Those of an edit who are still there become the selection.
void selectPeopleOf(EditorState& state, std::size_t edit);

/// "still, 0:05.0–0:07.5"
[[nodiscard]] QString handEditText(const model::HandEdit& edit, const model::Scene& scene);

} // namespace crowd::widgets
