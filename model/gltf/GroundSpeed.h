// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/gltf/ClipNames.h"
#include "model/template/Template.h"

namespace crowd::model::gltf {

/// Sets speed and root motion of every clip; see analyseClips. Bounds are already measured.
///
/// Root motion: the body ends where it began but for a horizontal shift that is large against the
/// change of its shape (a walk, not a fall). Foot contact: the lowest points of the body move over
/// the ground with one steady velocity while they touch it; the body then walks the other way.
/// What a name (one of `uses` per clip) says to be a gait gets the speed of its stride where no
/// foot keeps to the ground.
void findGroundSpeeds(Template& asset, bool removeRootMotion, const std::vector<NamedUse>& uses);

/// How the ground passes under the feet of an in-place clip, m/s, template frame; zero where the
/// feet do not keep to one velocity.
[[nodiscard]] glm::vec3 footVelocity(const Template& asset, int clip);

} // namespace crowd::model::gltf
