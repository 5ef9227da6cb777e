// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/pick/StageRays.h"

namespace crowd::widgets {

/// Three corners, metres, world frame.
using GroundTriangle = std::array<glm::vec3, 3>;

/// A straight piece of a band. Its borders lie so many metres to the right of its middle line
/// (negative: to the left) at either end.
struct BandShape
{
    glm::vec3 from{0.0F};
    glm::vec3 to{0.0F};
    glm::vec2 fromAside{-1.0F, 1.0F};
    glm::vec2 toAside{-1.0F, 1.0F};
};

/// A disc, or a ring where `inner` is above zero.
struct RingShape
{
    glm::vec3 center{0.0F};
    float inner = 0.0F; ///< metres
    float outer = 1.0F;
};

/// Lays flat shapes on the stage and the ground: they go up steps and over hills, stay on a bridge
/// or under it, and lie a little above what they lie on. Where there is nothing near, they are as
/// high as the shape says. What was laid out before is remembered. Main thread.
class GroundSheets
{
public:
    /// Begins anew: what is not asked for until the next begin() is forgotten by then. The rays
    /// stay alive until then. Samples lie `cell` metres apart, closer where the ground is uneven.
    void begin(const model::StageRays& rays, float cell);

    [[nodiscard]] const std::vector<GroundTriangle>& band(const BandShape& shape);
    [[nodiscard]] const std::vector<GroundTriangle>& ring(const RingShape& shape);
    /// The point above or below that lies on what is nearest in height, at most `reach` metres off.
    /// What lies close under something else does not count.
    [[nodiscard]] glm::vec3 onGround(const glm::vec3& point, float reach) const;
    /// How far the ground between two places may be from the line between them, at a share of it.
    [[nodiscard]] static float reachBetween(float metres, float share);

private:
    using Key = std::array<float, 11>;
    using Sheets = std::map<Key, std::vector<GroundTriangle>>;
    /// Null: has to be laid out, into the new entry of m_sheets.
    [[nodiscard]] const std::vector<GroundTriangle>* remembered(const Key& key);

    const model::StageRays* m_rays = nullptr;
    std::uint64_t m_version = 0;
    float m_cell = 1.0F;
    Sheets m_before;
    Sheets m_sheets;
};

} // namespace crowd::widgets
