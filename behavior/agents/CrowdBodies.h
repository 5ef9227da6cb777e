// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "behavior/agents/AgentColumns.h"
#include "behavior/agents/TemplateTables.h"
#include "behavior/crowd/CrowdSimulation.h"
#include "model/population/Population.h"
#include "model/scene/Path.h"

/// What of agents and places the crowd simulation is given: bodies and walls.
namespace crowd::behavior {

/// Bodies anew where agents are shown; who moves keeps its velocity. `hasSurface`: they may be on
/// levels above each other.
void setBodies(CrowdSimulation& crowd, const model::Population& people, const AgentColumns& agents,
               const TemplateTables& templates, bool hasSurface);

/// Long bodies are turned as agents are shown.
void turnLongBodies(CrowdSimulation& crowd, const MotionState& motion);

/// The outlines of places that are obstacles, as walls.
void addObstacleWalls(std::span<const model::Place> places, std::vector<Wall>& walls);

} // namespace crowd::behavior
