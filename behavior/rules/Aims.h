// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "behavior/rules/actions/ActionScope.h"

namespace crowd::behavior {

/// What an action is about, where it is now. World frame, metres.
struct Aim
{
    glm::vec3 point{0.0F};
    std::uint32_t agent = kNoAgent; ///< where it is somebody
};

/// Nothing: there is nobody and no place.
[[nodiscard]] std::optional<Aim> aimOf(const ActionScope& scope, const model::AimChoice& choice);

} // namespace crowd::behavior
