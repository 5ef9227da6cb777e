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

} // namespace crowd::model
