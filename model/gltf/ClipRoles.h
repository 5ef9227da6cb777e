// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/gltf/ClipNames.h"
#include "model/template/Template.h"

namespace crowd::model::gltf {

/// What the names of all clips say.
[[nodiscard]] std::vector<NamedUse> usesOf(const Template& asset);

/// Sets the role of every clip, but where the file itself gave it, by its name, the way it goes and
/// how fast; speeds are already measured, and become usual ones for gaits that show none. Where no
/// name says so, what plants its feet and gets on is a gait.
void proposeRoles(Template& asset, const std::vector<NamedUse>& uses);

} // namespace crowd::model::gltf
