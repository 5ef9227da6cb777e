// SPDX-License-Identifier: MIT
#pragma once

#include "model/template/Template.h"

namespace crowd::model::gltf {

/// How much room the body takes in its default pose: most of its surface is within. Arms that are
/// stretched out, tails and what somebody carries do not count in full.
[[nodiscard]] Footprint footprintOf(const Template& asset);

} // namespace crowd::model::gltf
