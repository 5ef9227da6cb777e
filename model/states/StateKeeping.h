// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/base/Message.h"
#include "model/document/SceneEdit.h"
#include "model/population/Properties.h"
#include "model/scene/State.h"
#include "model/states/ChangeOver.h"

/// States are kept from a scene and given back to it.
namespace crowd::model {

/// What a state holds unless something else is said: everything but who and where people are.
[[nodiscard]] ColumnSet usualStateColumns();
[[nodiscard]] ColumnSet columnsOf(PropertyAspect aspect);
/// Where people stand and which seat they have go together: with one of them, both.
[[nodiscard]] ColumnSet withBothOfPlace(ColumnSet columns);

/// How these people are now, under a name and without an id, in withBothOfPlace() of the columns.
/// Ids ascend, all of them alive.
[[nodiscard]] State keepState(const Scene& scene, std::string name, ColumnSet columns,
                              std::span<const IndividualId> ids);

/// The names of a template as it is now, as far as these columns go by them.
[[nodiscard]] StateTemplate rememberedTemplate(const TemplateEntry& entry, ColumnSet columns);

/// The same state with other columns: what it did not hold yet is as in `now`, of those who are
/// there; the rest stays as it was.
[[nodiscard]] State withColumns(const State& state, ColumnSet columns, const Scene& now);

/// By its name; null: there is none.
[[nodiscard]] const State* findState(const Scene& scene, const std::string& name);
/// The smallest that none of them has, and that no rule, cue or mark of the scene names: a new
/// state must not be taken for one that is gone.
[[nodiscard]] StateId freeStateId(const std::vector<State>& states, const Scene& scene);
/// Takes the place of the one of that name, whose id it gets; else it comes last. In an edit.
void putState(SceneEdit& edit, State state);

/// What came of giving a state back.
struct StateRecall
{
    std::vector<IndividualId> changed; ///< ascending
    std::vector<Message> notes;        ///< what did not fit, for the artist
};

/// Of a state's columns those that are also among these: where people are, and their seats, go
/// together.
[[nodiscard]] ColumnSet recalledColumns(const State& state, ColumnSet columns);
/// Who of the state is still there; `ids`: of these alone, ascending; null: all of the state.
[[nodiscard]] std::vector<IndividualId> peopleOf(const Scene& scene, const State& state,
                                                 const std::vector<IndividualId>* ids = nullptr);

/// peopleOf() become as they were then, in recalledColumns(). Clips, slots and parts go by name:
/// who has none of that name keeps his. So does who would get a seat that somebody else has, or a
/// template, path or group that is gone. `timing` is how those who show the scene as it plays
/// change over to that; the scene itself changes at once.
[[nodiscard]] StateRecall recallState(SceneEdit& edit, const State& state, ColumnSet columns,
                                      const std::vector<IndividualId>* ids = nullptr,
                                      const RecallTiming& timing = {});
/// The same at once, and without anybody being told that it was a state.
[[nodiscard]] StateRecall giveBack(SceneEdit& edit, const State& state, ColumnSet columns,
                                   const std::vector<IndividualId>* ids);
/// The same to a scene that is nobody's document.
[[nodiscard]] StateRecall recallState(Scene& scene, const State& state, ColumnSet columns,
                                      const std::vector<IndividualId>* ids = nullptr);

} // namespace crowd::model
