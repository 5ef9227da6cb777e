// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace crowd::model {

/// A disc on the ground that somebody stands on.
struct GroundDisc
{
    glm::vec3 at{0.0F}; ///< foot point
    float wider = 0.0F; ///< metres by which its radius is above that of a person; never below 0
};

/// Foot points hashed by cells of the ground plane: is anybody nearer than a distance? Metres. The
/// distance is that between people; wide bodies keep as much room between each other.
class NeighbourGrid
{
public:
    /// `distance`: the one that isFree asks for.
    NeighbourGrid(std::span<const GroundDisc> discs, float distance);

    [[nodiscard]] bool isFree(const GroundDisc& disc) const;
    void add(const GroundDisc& disc);
    [[nodiscard]] std::size_t size() const { return m_discs.size(); }
    /// Forgets all but the first `count` discs.
    void truncate(std::size_t count);

private:
    [[nodiscard]] std::size_t bucketOf(std::int64_t x, std::int64_t z) const;
    [[nodiscard]] std::int64_t cellOf(float metres) const;
    void grow();

    float m_distance;
    double m_cell;
    float m_widest = 0.0F; ///< of GroundDisc::wider, also of those forgotten
    std::vector<GroundDisc> m_discs;
    std::vector<std::int32_t> m_next;  ///< older disc of the same bucket, -1 none
    std::vector<std::int32_t> m_heads; ///< newest disc of a bucket; a power of two long
};

} // namespace crowd::model
