// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::behavior {

/// One of the crowd, as all but the force kernel see it. World frame seen from above, metres and
/// metres per second. What one needs of somebody lies together, so that people who stand in any
/// order can be brought into that of the bins and back at the cost of one access each.
struct alignas(32) Body
{
    float x = 0.0F;
    float z = 0.0F;
    float velocityX = 0.0F;
    float velocityZ = 0.0F;
    float desiredX = 0.0F; ///< velocity that it would like
    float desiredZ = 0.0F;
    /// 0: stands or sits, an obstacle that does not move; below 0: is coming to rest, straight on
    /// and slowing down by so many m/s².
    float preferredSpeed = 0.0F;
    float radius = 0.25F;
};

} // namespace crowd::behavior
