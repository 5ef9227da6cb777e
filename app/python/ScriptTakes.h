// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "app/python/ScriptScene.h"
#include "app/python/ScriptSession.h"
#include "behavior/takes/RetakeKeeping.h"

/// What scripts do with kept takes; each is a step. Errors name what there is.
namespace crowd::app {

/// Nothing: the scene as it plays.
[[nodiscard]] model::Result<void> showTake(ScriptScene& script,
                                           const std::optional<std::string>& name);
/// A file with a take's motion becomes a take. `id`: 0: the next one.
[[nodiscard]] model::Result<model::Take> addTake(ScriptScene& script, const std::string& path,
                                                 const std::string& name, model::TakeId id);
[[nodiscard]] model::Result<void> renameTake(ScriptScene& script, const std::string& name,
                                             const std::string& to);
[[nodiscard]] model::Result<void> removeTake(ScriptScene& script, const std::string& name);
/// What is done to people of it by hand: a list as JSON (see readHandEdits). `areOn`: all of it.
[[nodiscard]] model::Result<void> setHandEdits(ScriptScene& script, const std::string& name,
                                               const std::string& edits, bool areOn);
/// A moment of a take, from which a session of its scene goes on.
[[nodiscard]] model::Result<behavior::RunBeginning>
beginningInTake(const ScriptScene& script, const std::string& name, double seconds);
/// What a session has recorded becomes a take of its scene. The name is no other's.
[[nodiscard]] model::Result<model::Take> keepTake(ScriptSession& session, const std::string& name,
                                                  const model::KeepGoing& goesOn);

/// Some people of a take do something again, everybody else what he did: that becomes another take.
struct ScriptRetake
{
    std::string take;
    std::string name; ///< no other's
    behavior::RetakeOrder order;
};
[[nodiscard]] model::Result<model::Take> retake(ScriptScene& script, const ScriptRetake& wish,
                                                const model::KeepGoing& goesOn);

} // namespace crowd::app
