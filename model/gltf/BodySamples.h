// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "model/bake/Pose.h"
#include "model/template/Template.h"

/// A few vertices of a body, looked at in many poses.
namespace crowd::model::gltf {

/// Some vertices of a mesh as a mesh of their own.
[[nodiscard]] Mesh excerpt(const Mesh& mesh, const std::vector<std::size_t>& vertices);
/// Spread over all of level 0.
[[nodiscard]] Mesh evenExcerpt(const Mesh& mesh);
/// Those of level 0 that are lowest in the default pose.
[[nodiscard]] Mesh lowExcerpt(const Template& asset);

/// The vertices of an excerpt at a moment of a clip, template frame; those that are nowhere at 0.
[[nodiscard]] std::vector<glm::vec3> pointsAt(const Template& asset, const Mesh& mesh, int clip,
                                              float seconds, Pose& pose);
/// The same at `moments` + 1 moments, evenly over the clip, its end among them.
[[nodiscard]] std::vector<std::vector<glm::vec3>>
pointsOver(const Template& asset, const Mesh& mesh, int clip, int moments, Pose& pose);
/// So many of them show how feet touch the ground.
[[nodiscard]] int momentsOf(const Clip& clip);

/// What one pose of each clip costs: nodes, channels and vertices.
[[nodiscard]] double workOfAPose(const Template& asset);
inline constexpr double kMostWork = 2e8; ///< of that, over all clips and poses
inline constexpr int kMaxMoments = 96;

[[nodiscard]] inline glm::vec3 horizontal(const glm::vec3& v)
{
    return {v.x, 0.0F, v.z};
}

} // namespace crowd::model::gltf
