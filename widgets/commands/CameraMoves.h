// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/base/Bounds.h"
#include "model/view/View.h"

/// How a camera moves: pure functions from camera to camera. World frame, metres, radians, logical
/// pixels (y down). Everything is bounded: no way leads through the ground of numbers to a camera
/// that shows nothing any more.
namespace crowd::widgets {

/// A named direction to look in. Characters face +Z, so the front view looks along -Z.
enum class ViewDirection : unsigned char { Top, Front, Side };

/// Turns around a point: yaw about the vertical, pitch about the camera's own right. Stops short of
/// looking straight up or down, unless it is already there and goes away from it.
[[nodiscard]] model::Camera orbited(const model::Camera& camera, const glm::vec3& around,
                                    float yawRadians, float pitchRadians);
/// Turns in place.
[[nodiscard]] model::Camera turned(const model::Camera& camera, float yawRadians,
                                   float pitchRadians);
/// Moves sideways so that what is `depth` metres deep follows the pointer by `pixels`.
[[nodiscard]] model::Camera panned(const model::Camera& camera, glm::vec2 viewSize,
                                   glm::vec2 pixels, float depth);
/// Shrinks (factor < 1) or stretches the way to a point, which stays at its pixel.
[[nodiscard]] model::Camera dollied(const model::Camera& camera, const glm::vec3& towards,
                                    float factor);
/// Moves by metres along the camera's right, up and forward.
[[nodiscard]] model::Camera flown(const model::Camera& camera, const glm::vec3& metres);
/// The same direction, all of the box in the picture.
[[nodiscard]] model::Camera framed(const model::Camera& camera, glm::vec2 viewSize,
                                   const model::Bounds& box);
/// Looks at the same pivot from elsewhere.
[[nodiscard]] model::Camera lookingFrom(const model::Camera& camera, ViewDirection direction);
/// The other projection; what is at the pivot keeps its size in the picture.
[[nodiscard]] model::Camera withOtherProjection(const model::Camera& camera);

/// Depth of a point along the camera's axis, at least a hand's breadth.
[[nodiscard]] float depthOf(const model::Camera& camera, const glm::vec3& point);

} // namespace crowd::widgets
