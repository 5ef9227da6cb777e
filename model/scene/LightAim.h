// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "model/scene/CrowdFrame.h"
#include "model/scene/Light.h"

namespace crowd::model {

/// The middle of what a light shines on, where people are in that frame (null: nobody is there).
/// Nothing: it goes with somebody, or a group, who is gone. World frame, metres.
[[nodiscard]] std::optional<glm::vec3> aimedAt(const Light& light, const CrowdFrame* frame);
/// A point of its cone's edge, where it meets the plane across the way to its target: the one that
/// lies farthest in that direction.
[[nodiscard]] glm::vec3 coneEdge(const Light& light, const glm::vec3& target,
                                 const glm::vec3& direction);

} // namespace crowd::model
