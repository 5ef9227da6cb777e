// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "model/document/SceneEdit.h"

/// Groups (see Group) in an open edit. Main thread.
namespace crowd::model {

/// A new group with an id above all that people are in or that there is a group of; 0 when none is
/// left.
GroupId addGroup(SceneEdit& edit, Group group);
/// By id; where people have a number that there is no group of, it comes to be.
void changeGroup(SceneEdit& edit, const Group& group);
/// Its people stay, in no group.
void removeGroup(SceneEdit& edit, GroupId id);
/// Takes people into a group; 0: out of theirs. Ids ascending, all present.
void putInGroup(SceneEdit& edit, std::span<const IndividualId> ids, GroupId group);
/// The others are hidden, it is not. Once more: all are shown.
void soloGroup(SceneEdit& edit, GroupId id);

/// The name itself, or with a number behind it that no other has.
[[nodiscard]] std::string freeGroupName(const Scene& scene, const std::string& wanted);

} // namespace crowd::model
