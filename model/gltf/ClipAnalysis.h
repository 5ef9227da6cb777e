// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/template/Template.h"

/// What an import finds out about a template's clips by looking at their poses.
namespace crowd::model::gltf {

/// Sets the ground speed of every clip (net root motion, else the extras, else foot contact), takes
/// root motion out unless told not to, picks the standing and the seated clip, and measures bounds
/// and height. Nodes, bones, levels, slots, clips and root correction are there.
void analyseClips(Template& asset, bool removeRootMotion);

/// The clip to stand in: the most idle-like name, never a reset, static, bind or T pose while there
/// is anything else.
[[nodiscard]] int chooseDefaultClip(const std::vector<Clip>& clips);

/// Bounds of level 0, shown parts, at a moment of a clip (-1: rest), template frame.
[[nodiscard]] Bounds boundsAt(const Template& asset, int clip, float seconds);

} // namespace crowd::model::gltf
