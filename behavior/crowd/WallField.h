// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace crowd::behavior {

/// A straight wall, seen from above (x, z), metres; it stops people on both sides whose feet are
/// between the heights.
struct Wall
{
    glm::vec2 a{0.0F};
    glm::vec2 b{0.0F};
    float low = -1e9F;
    float high = 1e9F;
    /// Stops only who comes from the side that (-z, x) of its way from a to b points to. Whoever is
    /// on the other side, behind it, gets past.
    bool isOneSided = false;
};

/// What of a wall can be nearest to a body: its side, or a corner where sides meet. Kept apart so
/// that a wall made of many pieces presses like one.
struct WallPiece
{
    glm::vec2 at{0.0F};
    glm::vec2 along{0.0F};  ///< unit: of the side; of the first side that leaves a corner
    glm::vec2 second{0.0F}; ///< of the other side that leaves the corner; zero: none
    float length = 0.0F;    ///< of the side; 0: a corner
    float low = 0.0F;
    float high = 0.0F;
    bool isOneSided = false; ///< of a side: see Wall

    /// Whether somebody so far away from the side is behind it.
    [[nodiscard]] bool letsOut(float awayX, float awayZ) const
    {
        return isOneSided && awayX * -along.y + awayZ * along.x < 0.0F;
    }
};

/// All walls, found by where one stands. Immutable between setWalls(); read on any thread.
class WallField
{
public:
    /// Walls without length, or with a coordinate that is no number, are left out. People notice
    /// walls up to `reach` metres away.
    void setWalls(std::span<const Wall> walls, float reach);

    [[nodiscard]] bool isEmpty() const { return m_pieces.empty(); }
    /// Pieces that may be within reach of a point; indices into pieces().
    [[nodiscard]] std::span<const std::uint32_t> near(float x, float z) const;
    [[nodiscard]] const WallPiece& piece(std::uint32_t index) const { return m_pieces[index]; }

private:
    void addCorners(std::span<const Wall> walls);
    void layOut(float reach);
    [[nodiscard]] float placeBins(float reach);
    void listPiece(std::uint32_t index, float bin, float reach,
                   std::vector<std::vector<std::uint32_t>>& lists) const;

    std::vector<WallPiece> m_pieces;
    glm::vec2 m_low{0.0F};
    float m_perMetre = 1.0F;
    int m_width = 0;
    int m_depth = 0;
    std::vector<std::uint32_t> m_start;
    std::vector<std::uint32_t> m_items;
};

inline std::span<const std::uint32_t> WallField::near(float x, float z) const
{
    const float column = (x - m_low.x) * m_perMetre;
    const float line = (z - m_low.y) * m_perMetre;
    if (!(column >= 0.0F && line >= 0.0F && column < static_cast<float>(m_width) &&
          line < static_cast<float>(m_depth))) {
        return {};
    }
    const auto bin = static_cast<std::size_t>(line) * static_cast<std::size_t>(m_width) +
                     static_cast<std::size_t>(column);
    return std::span(m_items).subspan(m_start[bin], m_start[bin + 1] - m_start[bin]);
}

/// Vector from the nearest point of a piece to a point at (x, z), when that piece is the one to
/// reckon with; false when another piece of the same wall is.
[[nodiscard]] [[gnu::always_inline]] inline bool awayFrom(const WallPiece& piece, float x, float z,
                                                          float& awayX, float& awayZ)
{
    const float fromX = x - piece.at.x;
    const float fromZ = z - piece.at.y;
    const float along = fromX * piece.along.x + fromZ * piece.along.y;
    if (piece.length > 0.0F) {
        awayX = fromX - along * piece.along.x;
        awayZ = fromZ - along * piece.along.y;
        return along > 0.0F && along < piece.length;
    }
    awayX = fromX;
    awayZ = fromZ;
    return along <= 0.0F && fromX * piece.second.x + fromZ * piece.second.y <= 0.0F;
}

} // namespace crowd::behavior
