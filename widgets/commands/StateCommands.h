// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <QtCore/QString>

#include "model/population/ColumnSet.h"
#include "model/population/Properties.h"
#include "model/scene/State.h"
#include "widgets/state/EditorState.h"

/// What panels, menus and keys do with kept states: one undo step each, nothing while something
/// else is edited. They say in the status bar what came of it.
namespace crowd::widgets {

/// Of whom a state is kept.
enum class StateReach : std::uint8_t { Everybody, Selected, Group };

/// As a state is recalled now; along the view means away from where one looks from.
[[nodiscard]] model::RecallTiming timingNow(const EditorState& state);
/// "State 3": a name that none has.
[[nodiscard]] QString freeStateName(const model::Scene& scene);
/// As they are seen now, also while it plays. Whether there was somebody to keep it of.
/// `group`: of that reach.
bool keepStateAs(EditorState& state, const QString& name, model::ColumnSet columns,
                 StateReach reach, model::GroupId group = 0);
/// What it holds from now on: what it did not hold yet is as people are seen now.
void setHeld(EditorState& state, model::StateId id, model::PropertyAspect aspect, bool isHeld);
/// How they are seen now, of the same people as far as they are there, with the same properties.
void keepStateAnew(EditorState& state, model::StateId id);
/// Where a state goes.
enum class RecallInto : std::uint8_t {
    Scene, ///< one undo step
    Run    ///< while it plays in the run alone, until it ends; else the scene
};

/// As EditorState::recall() says: over some time where it plays.
void recallStateOf(EditorState& state, model::StateId id, RecallInto into);
void removeState(EditorState& state, model::StateId id);
/// Whether it has that name now.
bool renameState(EditorState& state, model::StateId id, const QString& name);
/// Before the one that is so many places further.
void moveState(EditorState& state, model::StateId id, int by);
void selectPeopleOf(EditorState& state, model::StateId id);

} // namespace crowd::widgets
