// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/crowd/CrowdSimulation.h"
#include "behavior/crowd/ParkedBodies.h"
#include "behavior/motion/PathFollower.h"
#include "behavior/surface/WalkSurface.h"

namespace crowd::behavior {

/// Leads those who walk around long bodies that stand in their way and are no part of the stage.
class ParkedDetours
{
public:
    /// Bends the velocities that bodies desire. `surface` null: open ground.
    void apply(CrowdSimulation& crowd, const PathFollower& follower, const WalkSurface* surface);

private:
    ParkedBodies m_parked;
};

} // namespace crowd::behavior
