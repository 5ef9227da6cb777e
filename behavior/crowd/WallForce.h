// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "behavior/crowd/FastExp.h"
#include "behavior/crowd/ForceParameters.h"
#include "behavior/crowd/WallField.h"

/// What walls do to one body; part of the force kernel, a header so that it is compiled into each
/// of its copies.
namespace crowd::behavior {

inline constexpr float kSmallest = 1e-6F;

/// Where a body is that walls are near to. World frame seen from above, metres; y: its feet.
struct BodyPlace
{
    float x = 0.0F;
    float z = 0.0F;
    float y = 0.0F;
    float radius = 0.0F;
};

struct WallPull
{
    float x = 0.0F; ///< m/s²
    float z = 0.0F;
    float hidden = 0.0F; ///< share of what one sees around that lies behind walls
};

[[nodiscard]] inline WallPull wallPull(const WallField& walls, const ForceParameters& p,
                                       const BodyPlace& self)
{
    WallPull pull;
    for (const std::uint32_t index : walls.near(self.x, self.z)) {
        const WallPiece& piece = walls.piece(index);
        float awayX = 0.0F;
        float awayZ = 0.0F;
        if (self.y < piece.low || self.y > piece.high ||
            !awayFrom(piece, self.x, self.z, awayX, awayZ) || piece.letsOut(awayX, awayZ)) {
            continue;
        }
        const float distance = std::sqrt(std::max(awayX * awayX + awayZ * awayZ, kSmallest));
        const float gap = self.radius - distance;
        // Someone inside a wall is pushed out firmly, not shot out.
        const float push = p.wallStrength * fastExp(std::min(gap, 0.0F) / p.wallReach) +
                           p.wallContact * std::max(gap, 0.0F);
        pull.x += push * awayX / distance;
        pull.z += push * awayZ / distance;
        const float inside = std::max(1.0F - distance / p.range, 0.0F);
        pull.hidden += 0.5F * inside * inside;
    }
    return pull;
}

/// Metres from where a body was, as far as it may come in a step: as far as it wanted, or at a walk
/// where it got into a wall that was not there before.
inline void leaveAtAWalk(const BodyPlace& self, float wanted, float seconds, float& x, float& z)
{
    constexpr float kLeavingSpeed = 1.3F; // m/s
    const float wayX = x - self.x;
    const float wayZ = z - self.z;
    const float way = std::sqrt(wayX * wayX + wayZ * wayZ);
    const float most = std::max(wanted, kLeavingSpeed * seconds);
    if (way > most) {
        x = self.x + wayX * (most / way);
        z = self.z + wayZ * (most / way);
    }
}

/// Where a body may stand that wants to be at (x, z): out of the walls it touches.
inline void keepOutOfWalls(const WallField& walls, const BodyPlace& self, float seconds, float& x,
                           float& z)
{
    const float wanted = std::sqrt((x - self.x) * (x - self.x) + (z - self.z) * (z - self.z));
    for (const std::uint32_t index : walls.near(x, z)) {
        const WallPiece& piece = walls.piece(index);
        float awayX = 0.0F;
        float awayZ = 0.0F;
        if (self.y < piece.low || self.y > piece.high || !awayFrom(piece, x, z, awayX, awayZ) ||
            piece.letsOut(awayX, awayZ)) {
            continue;
        }
        const float squared = awayX * awayX + awayZ * awayZ;
        if (squared < self.radius * self.radius && squared > kSmallest) {
            const float further = self.radius / std::sqrt(squared) - 1.0F;
            x += awayX * further;
            z += awayZ * further;
        }
    }
    leaveAtAWalk(self, wanted, seconds, x, z);
    // Whoever was squeezed through a wall stays where he was.
    for (const std::uint32_t index : walls.near(self.x, self.z)) {
        const WallPiece& piece = walls.piece(index);
        if (piece.length == 0.0F || self.y < piece.low || self.y > piece.high) {
            continue;
        }
        const float normalX = -piece.along.y;
        const float normalZ = piece.along.x;
        const float before = (self.x - piece.at.x) * normalX + (self.z - piece.at.y) * normalZ;
        const float after = (x - piece.at.x) * normalX + (z - piece.at.y) * normalZ;
        if ((before > 0.0F) == (after > 0.0F) || (piece.isOneSided && before <= 0.0F)) {
            continue;
        }
        const float share = before / (before - after);
        const float crossX = self.x + (x - self.x) * share - piece.at.x;
        const float crossZ = self.z + (z - self.z) * share - piece.at.y;
        const float along = crossX * piece.along.x + crossZ * piece.along.y;
        if (along >= 0.0F && along <= piece.length) {
            x = self.x;
            z = self.z;
            return;
        }
    }
}

} // namespace crowd::behavior
