// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace crowd::model {

/// Why nobody walks at a point, by the setting that would change it (SurfaceSettings).
enum class WalkRefusal : std::uint8_t {
    None,
    Steep,   ///< than `slopeDegrees`
    Low,     ///< something is above, nearer than `height`
    Narrow,  ///< no `radius` from what can be walked on, nor as far from an edge
    Unlinked ///< no way leads there, over steps of `climb` at most
};

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
    /// Why isWalkable() says no.
    [[nodiscard]] virtual WalkRefusal refusal(const glm::vec3& point) const
    {
        return isWalkable(point) ? WalkRefusal::None : WalkRefusal::Unlinked;
    }
    /// Metres of the way from one point to another, as seen from above: infinite where no way comes
    /// within so many metres of it. Nothing where `from` is on no ground.
    [[nodiscard]] virtual std::optional<float>
    wayMetres(const glm::vec3& /*from*/, const glm::vec3& /*to*/, float /*within*/) const
    {
        return std::nullopt;
    }
    /// All of it, to be shown; without the open ground about the stages.
    [[nodiscard]] virtual std::vector<std::array<glm::vec3, 3>> triangles() const { return {}; }
};

using WalkableGroundPtr = std::shared_ptr<const WalkableGround>;
/// Asks for it, and waits until it is there; null: there is nothing but open ground.
using WalkableGroundSource = std::function<WalkableGroundPtr()>;

} // namespace crowd::model
