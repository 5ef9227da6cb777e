// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "model/bake/Pose.h"
#include "model/bake/Skinning.h"
#include "tests/model/GltfBuilder.h"

/// Small glTF files that several tests begin with, and what they show.
namespace gltf_samples {

using Json = GltfBuilder::Json;

inline bool near(const glm::vec3& a, const glm::vec3& b)
{
    return glm::length(a - b) < 1e-5F;
}

inline Json& primitive(GltfBuilder& builder)
{
    return builder.root["meshes"][0]["primitives"][0];
}

/// A triangle that follows two joints, one metre apart, one vertex each and one both.
inline GltfBuilder skinned()
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int joints = builder.accessor<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
    const int weights = builder.accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 3, 0, 0}, "VEC4");
    primitive(builder)["attributes"]["JOINTS_0"] = joints;
    primitive(builder)["attributes"]["WEIGHTS_0"] = weights;
    builder.root["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {50, 0, 0}}},
                             {{"name", "hips"}, {"children", {2}}},
                             {{"name", "head"}, {"translation", {0, 1, 0}}}};
    builder.root["scenes"][0]["nodes"] = {0, 1};
    builder.add("skins", {{"joints", {1, 2}}});
    return builder;
}

/// Appends a clip of one channel: three floats a key, or four for rotations.
inline void animate(GltfBuilder& builder, const Json& clip, int node, const char* path,
                    const std::vector<float>& times, const std::vector<float>& values)
{
    const int input = builder.accessor(times, "SCALAR");
    const int output = builder.accessor(values, std::string(path) == "rotation" ? "VEC4" : "VEC3");
    Json animation = clip;
    animation["samplers"] = {{{"input", input}, {"output", output}}};
    animation["channels"] = {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}};
    builder.add("animations", animation);
}

/// The deformed vertices; a clip of -1 is the resting pose.
inline std::vector<glm::vec3> posed(const crowd::model::Template& asset, int clip, float seconds,
                                    std::size_t level = 0)
{
    crowd::model::Pose pose;
    crowd::model::evaluatePose(asset, clip, seconds, pose);
    std::vector<glm::vec3> positions(asset.levels[level].positions.size());
    crowd::model::skin(asset.levels[level], pose.bones, positions, {});
    return positions;
}

} // namespace gltf_samples
