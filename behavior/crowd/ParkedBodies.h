// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "behavior/crowd/Body.h"
#include "behavior/crowd/LongBodies.h"

namespace crowd::behavior {

/// Somebody who wants to go straight to a point. World frame from above, metres.
struct Walker
{
    glm::vec2 at{0.0F};
    glm::vec2 aim{0.0F};
    float radius = 0.25F;
    float height = 0.0F; ///< of the ground underfoot
};

/// Long bodies that stand: whoever meets the flank of one is pushed back, not aside, so he has to
/// be told how to go around it. Those between which nobody gets through are gone around as one. Any
/// thread asks; one at a time gathers.
class ParkedBodies
{
public:
    /// Whether one gets straight from the first point to the second, as far as walls go.
    using IsClear = std::function<bool(const glm::vec2&, const glm::vec2&)>;

    /// Those who stand by now; heights of the ground underfoot, by agent.
    void gather(std::span<const LongBody> longBodies, std::span<const Body> bodies,
                std::span<const float> heights);
    [[nodiscard]] bool isEmpty() const { return m_capsules.empty(); }
    /// Unit vector along which he gets around what stands between him and his aim, on the side
    /// that is nearer. Nothing: nothing does, or there is no way around it.
    [[nodiscard]] std::optional<glm::vec2> around(const Walker& who, const IsClear& isClear) const;

private:
    /// All points within `radius` of a line.
    struct Capsule
    {
        glm::vec2 a{0.0F};
        glm::vec2 b{0.0F};
        float radius = 0.0F;
        float height = 0.0F;
        friend bool operator==(const Capsule&, const Capsule&) = default;
    };
    struct Cluster
    {
        std::size_t begin = 0; ///< among the capsules
        std::size_t end = 0;
        glm::vec2 middle{0.0F};
    };
    /// Angles that a cluster fills, radians from the way somebody wants to go.
    struct Span
    {
        float low = 0.0F;
        float high = 0.0F;
        float metres = 0.0F; ///< to the tangent points, at most
    };
    using Cell = std::pair<std::int32_t, std::int32_t>;

    void cluster();
    void layOut();
    [[nodiscard]] bool isMet(const Cluster& cluster, const Walker& who, const glm::vec2& end,
                             float room) const;
    [[nodiscard]] Span spanOf(const Cluster& cluster, const Walker& who,
                              const glm::vec2& ahead) const;
    [[nodiscard]] static Cell cellOf(const glm::vec2& at);

    std::vector<Capsule> m_former; ///< as they were gathered: most stay as they are
    std::vector<Capsule> m_capsules;
    std::vector<Cluster> m_clusters;
    std::map<Cell, std::vector<std::uint32_t>> m_near; ///< clusters that somebody there may meet
};

} // namespace crowd::behavior
