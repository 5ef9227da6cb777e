// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/scene/Path.h"

/// What ground a place takes up. World frame, metres; two numbers are x and z, seen from above.
namespace crowd::model {

/// The corners of a line or an area where they lie in the world; of a round one none.
[[nodiscard]] std::vector<glm::vec3> cornersOf(const Place& place);
/// The point nearest to `at` of what all of a place lies around: its middle, its line, or its area.
[[nodiscard]] glm::vec2 nearestOf(const Place& place, glm::vec2 at);
/// Whether it belongs to the place, however high it lies.
[[nodiscard]] bool isWithin(const Place& place, const glm::vec3& at);
/// Whether the corners enclose it: an odd number of sides lies on its one side.
[[nodiscard]] bool isEnclosed(std::span<const glm::vec3> corners, glm::vec2 at);
/// Metres from its position, seen from above, within which all of it lies.
[[nodiscard]] float reachOf(const Place& place);
/// Metres along its corners, seen from above; 0 of a round one.
[[nodiscard]] float lengthOf(const Place& place);
/// Square metres.
[[nodiscard]] float areaOf(const Place& place);
/// So many have room in it where nobody lines up; see Place::capacity.
[[nodiscard]] std::uint32_t roomOf(const Place& place);
/// Its corners in the world: its position becomes their middle, on the area where it is one. At
/// least one corner, at most kMostCorners.
void setCorners(Place& place, std::span<const glm::vec3> corners);
/// Whether its corners make the shape that it has: two or more of a line, three of an area, none
/// too far off.
[[nodiscard]] bool isWhole(const Place& place);

} // namespace crowd::model
