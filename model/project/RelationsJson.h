// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/JsonEntries.h"
#include "model/scene/SceneMembers.h"

namespace crowd::model {

/// Kinds of relations as a member of the project file, which describes itself (see MemberJson.h);
/// without it they are readyRelations(). Ids and names are of no other one.
void readMember(members::RelationKinds, JsonFields& top, Scene& scene, Message& problem);

/// Relations are a table (see LinkParser.h); here is what stands beside its rows.
[[nodiscard]] nlohmann::json memberJson(members::Relations, const Scene& scene);
void readMember(members::Relations, JsonFields& top, Scene& scene, Message& problem);

} // namespace crowd::model
