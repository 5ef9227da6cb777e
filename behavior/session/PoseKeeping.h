// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/session/SessionPose.h"
#include "model/document/SceneEdit.h"

/// What a session has made of people, written into the scene.
namespace crowd::behavior {

/// What is shown of the properties that sessions write: where people are, which way they look, on
/// which seats they sit, with the clips to sit or stand with; who has left stays where he began. Of
/// `pose` (null: nothing) what states have made of people in the session alone, the properties that
/// rules have set, and the artist's numbers that people begin with. How many people stand or sit
/// another way than before.
int keepPose(model::SceneEdit& edit, const model::Population& shown, const SessionPose* pose);

/// The clips that people are seen in become theirs, from where they are in them. Not of those who
/// follow a path: what they are seen in is how they get about.
void keepClips(model::SceneEdit& edit, const model::Population& shown);

} // namespace crowd::behavior
