// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/session/SessionPose.h"
#include "model/document/SceneEdit.h"

/// What a session has made of people, written into the scene.
namespace crowd::behavior {

/// Where people are shown, which way they look and on which seats they sit, with the clips to sit
/// or stand with; who has left stays where he began. Of `pose` (null: nothing) what rules have set:
/// colours, heights, tags, own clips, and the artist's numbers that people begin with. How many
/// people stand or sit another way than before.
int keepPose(model::SceneEdit& edit, const model::Population& shown, const SessionPose* pose);

} // namespace crowd::behavior
