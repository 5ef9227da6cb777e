// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/JsonEntries.h"
#include "model/scene/SceneMembers.h"

namespace crowd::model {

/// Kinds of features as a member of the project file, which describes itself (see MemberJson.h);
/// without it they are readyFeatures(). Ids of values are of no other one, whatever their kind;
/// names are of no other one of the kind.
void readMember(members::Features, JsonFields& top, Scene& scene, Message& problem);

} // namespace crowd::model
