// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/base/Message.h"
#include "model/document/SceneEdit.h"
#include "model/population/Properties.h"
#include "model/scene/State.h"

/// States are kept from a scene and given back to it.
namespace crowd::model {

/// What a state holds unless something else is said: everything but who and where people are.
[[nodiscard]] ColumnSet usualStateColumns();
[[nodiscard]] ColumnSet columnsOf(PropertyAspect aspect);

/// How these people are now, under a name and without an id. Ids ascend, all of them alive. Where
/// people stand and which seat they have go together: with one of them it has both.
[[nodiscard]] State keepState(const Scene& scene, std::string name, ColumnSet columns,
                              std::span<const IndividualId> ids);

/// The names of a template as it is now, as far as these columns go by them.
[[nodiscard]] StateTemplate rememberedTemplate(const TemplateEntry& entry, ColumnSet columns);

/// By its name; null: there is none.
[[nodiscard]] const State* findState(const Scene& scene, const std::string& name);
/// The smallest that none of them has.
[[nodiscard]] StateId freeStateId(const std::vector<State>& states);
/// Takes the place of the one of that name, whose id it gets; else it comes last. In an edit.
void putState(SceneEdit& edit, State state);

/// What came of giving a state back.
struct StateRecall
{
    std::vector<IndividualId> changed; ///< ascending
    std::vector<Message> notes;        ///< what did not fit, for the artist
};

/// Who of the state is still there becomes as he was then, in those of its columns that are also in
/// `columns`. Clips, slots and parts go by name: who has none of that name keeps his. So does who
/// would get a seat that somebody else has, or a template, path or group that is gone. `ids`: these
/// alone, ascending; null: all of the state.
[[nodiscard]] StateRecall recallState(SceneEdit& edit, const State& state, ColumnSet columns,
                                      const std::vector<IndividualId>* ids = nullptr);

} // namespace crowd::model
