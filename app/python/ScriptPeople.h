// SPDX-License-Identifier: MIT
#pragma once

#include "app/python/ScriptScene.h"
#include "behavior/session/SessionPose.h"

/// Individuals as scripts change them. Each is a part of the open edit, or a step of its own; what
/// is refused is refused before anything changes.
namespace crowd::app {

/// Values for some columns of some individuals, as a script gives them: each n × stride bytes, in
/// the order of the ids it goes with.
struct ColumnValues
{
    model::ColumnId column = model::ColumnId::Position;
    std::vector<std::byte> bytes;
};

/// What becomes of groups and paths that the scene does not have. Recordings give back people who
/// were in one that is gone.
enum class MissingEntries : std::uint8_t { Refuse, Take };

/// n individuals with these values; the rest gets the defaults of their templates. Their ids.
/// Nobody where `keepGoing` says no; it is asked on the calling thread.
[[nodiscard]] model::Result<std::vector<model::IndividualId>>
createPeople(ScriptScene& script, std::size_t n, std::span<const ColumnValues> values,
             const model::KeepGoing& keepGoing = {},
             MissingEntries missing = MissingEntries::Refuse);
/// Ids ascending, all alive.
[[nodiscard]] model::Result<void> removePeople(ScriptScene& script,
                                               std::span<const model::IndividualId> ids);
[[nodiscard]] model::Result<void> changePeople(ScriptScene& script,
                                               std::span<const model::IndividualId> ids,
                                               std::span<const ColumnValues> values,
                                               const model::KeepGoing& keepGoing = {},
                                               MissingEntries missing = MissingEntries::Refuse);
/// People become as a session shows them. How many are another way than before.
/// `after`: as the scene is then.
[[nodiscard]] model::Result<int> keepPose(ScriptScene& script, const model::Population& shown,
                                          const behavior::SessionPose& pose,
                                          ScriptScene::Snapshot& after);
/// Those of them who stand where nobody can walk come to the nearest ground: one step. How many.
/// Ids ascending, all alive.
[[nodiscard]] model::Result<int> putOnGround(ScriptScene& script,
                                             std::span<const model::IndividualId> ids);

} // namespace crowd::app
