// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <glm/vec3.hpp>

namespace crowd::model {

/// Where people of the usual size can stand and walk away from: level enough, with room above the
/// head, and linked to the rest of the ground. Found outside of the model. Immutable, thread-safe,
/// the same for the same stages. World frame, metres.
class WalkableGround
{
public:
    virtual ~WalkableGround() = default;
    /// Whether somebody whose feet are there can walk about.
    [[nodiscard]] virtual bool isWalkable(const glm::vec3& point) const = 0;
    /// The point that somebody can walk about from which is nearest as seen from above, at the
    /// level nearest to the given one; none within some hundred metres: nothing.
    [[nodiscard]] virtual std::optional<glm::vec3> nearest(const glm::vec3& point) const = 0;
};

using WalkableGroundPtr = std::shared_ptr<const WalkableGround>;
/// Asks for it, and waits until it is there; null: there is nothing but open ground.
using WalkableGroundSource = std::function<WalkableGroundPtr()>;

} // namespace crowd::model
