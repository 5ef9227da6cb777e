// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/base/Result.h"

namespace tinygltf {
class Model;
struct Primitive;
} // namespace tinygltf

namespace crowd::model::gltf {

/// One primitive, decoded: arrays V long, in the file's order and the mesh's space.
struct PrimitiveData
{
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; ///< empty: to be computed flat
    std::vector<glm::vec2> uv;
    std::vector<glm::u8vec4> colors;
    int influences = 0;                 ///< a multiple of 4, 0 without a skin
    std::vector<std::uint32_t> joints;  ///< V × influences, into the skin's list
    std::vector<float> weights;         ///< sum 1 for each vertex
    std::vector<std::uint32_t> indices; ///< triangles; strips and fans are expanded
    std::vector<Message> warnings;
};

/// What decodePrimitive is asked for.
struct PrimitiveRequest
{
    int texCoord = 0;
    std::size_t joints = 0;           ///< of the node's skin; 0: leave the influences out
    std::vector<double> morphWeights; ///< resting weights of the morph targets
    std::string place;                ///< "meshes[1].primitives[0]", for messages
};

/// Whether it draws triangles at all: points and lines, and what has no positions, do not.
[[nodiscard]] bool drawsTriangles(const tinygltf::Primitive& primitive);

Result<PrimitiveData> decodePrimitive(const tinygltf::Model& model,
                                      const tinygltf::Primitive& primitive,
                                      const PrimitiveRequest& request);

} // namespace crowd::model::gltf
