// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace crowd::model {

/// Foot points hashed by cells of the ground plane: is anybody nearer than a distance? Metres.
class NeighbourGrid
{
public:
    /// `distance`: the one that isFree asks for.
    NeighbourGrid(std::span<const glm::vec3> points, float distance);

    [[nodiscard]] bool isFree(const glm::vec3& point) const;
    void add(const glm::vec3& point);
    [[nodiscard]] std::size_t size() const { return m_points.size(); }
    /// Forgets all but the first `count` points.
    void truncate(std::size_t count);

private:
    [[nodiscard]] std::size_t bucketOf(std::int64_t x, std::int64_t z) const;
    [[nodiscard]] std::int64_t cellOf(float metres) const;
    void grow();

    float m_distance;
    double m_cell;
    std::vector<glm::vec3> m_points;
    std::vector<std::int32_t> m_next;  ///< older point of the same bucket, -1 none
    std::vector<std::int32_t> m_heads; ///< newest point of a bucket; a power of two long
};

} // namespace crowd::model
