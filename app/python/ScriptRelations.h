// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/python/ScriptScene.h"

/// Relations as scripts give them: each call is a part of the open edit, or a step of its own. What
/// is refused is refused before anything changes.
namespace crowd::app {

/// What to say of a name that there is not.
[[nodiscard]] std::string noRelationText(const model::RelationKinds& kinds,
                                         const std::string& name);

/// One from and one to for each relation, or one for all; so with strengths.
struct GivenRelations
{
    std::vector<model::IndividualId> from;
    std::vector<model::IndividualId> to;
    std::vector<float> strength;
};

/// Relates them by the kind of that name; how many relations are another way than before.
[[nodiscard]] model::Result<std::size_t> relate(ScriptScene& script, const GivenRelations& given,
                                                const std::string& name);
/// Takes relations away: from each to each, one for one; no `to`: all that these have, whichever
/// way. No name: of any kind. How many there were.
[[nodiscard]] model::Result<std::size_t>
unrelate(ScriptScene& script, const std::vector<model::IndividualId>& from,
         const std::optional<std::vector<model::IndividualId>>& to,
         const std::optional<std::string>& name);
/// Ids of those to whom these are related, ascending; of a kind that is not mutual, in its
/// direction. No name: by any kind.
[[nodiscard]] model::Result<std::vector<model::IndividualId>>
related(const model::Scene& scene, const std::vector<model::IndividualId>& ids,
        const std::optional<std::string>& name);
/// Copies of people where `offset` says, with the relations among them; their ids, in order.
[[nodiscard]] model::Result<std::vector<model::IndividualId>>
duplicatePeople(ScriptScene& script, const std::vector<model::IndividualId>& ids,
                const glm::vec3& offset);

} // namespace crowd::app
