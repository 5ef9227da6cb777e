// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "behavior/session/SessionPose.h"
#include "model/document/SceneEdit.h"

/// What a session has made of people, written into the scene.
namespace crowd::widgets {

/// Where people are shown, which way they look and on which seats they sit, with the clips to sit
/// or stand with. Who has left stays where he began. How many people are another way than before.
int keepPlaces(model::SceneEdit& edit, const model::Population& shown);
/// Colours, heights, tags and own clips that rules have set.
void keepLooks(model::SceneEdit& edit, const std::vector<behavior::SetLook>& looks);
/// The artist's numbers that rules have changed become those that people begin with.
void keepNumbers(model::SceneEdit& edit, const std::vector<behavior::OwnNumber>& numbers);

} // namespace crowd::widgets
