// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/python/ScriptScene.h"
#include "model/states/StateKeeping.h"

/// States as scripts keep and recall them: each call is a part of the open edit, or a step of its
/// own. What is refused is refused before anything changes.
namespace crowd::app {

/// By the names of columns; "tint" is all of them. None: what states hold usually.
[[nodiscard]] model::Result<model::ColumnSet> stateColumns(const std::vector<std::string>* names);

/// Of these, ascending and alive; null: of everybody. One of that name is replaced.
[[nodiscard]] model::Result<void> saveState(ScriptScene& script, const std::string& name,
                                            model::ColumnSet columns,
                                            const std::vector<model::IndividualId>* ids);
/// Of a state that is given back.
struct RecallOrder
{
    std::optional<model::ColumnSet> columns;             ///< nothing: all that it holds
    std::optional<std::vector<model::IndividualId>> ids; ///< nothing: all of it; ascending
    model::RecallTiming timing;
};

/// Sessions of the scene, and the window that plays it, let people change over to it.
[[nodiscard]] model::Result<model::StateRecall>
recallState(ScriptScene& script, const std::string& name, const RecallOrder& order);
/// Whom and what it concerns in a scene: for sessions alone.
[[nodiscard]] model::Result<model::ChangeOver>
changeOverTo(const model::Scene& scene, const std::string& name, const RecallOrder& order);

[[nodiscard]] model::Result<void> removeState(ScriptScene& script, const std::string& name);
[[nodiscard]] model::Result<void> renameState(ScriptScene& script, const std::string& name,
                                              const std::string& to);
/// All names there are, in another order.
[[nodiscard]] model::Result<void> arrangeStates(ScriptScene& script,
                                                const std::vector<std::string>& names);
/// All of them, as statesText() has them.
[[nodiscard]] model::Result<void> setStates(ScriptScene& script, const std::string& text);

/// States as the text of a project file that has nothing else.
[[nodiscard]] std::string statesText(const std::vector<model::State>& states);

} // namespace crowd::app
