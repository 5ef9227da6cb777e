// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/base/Bounds.h"
#include "model/base/Message.h"
#include "model/template/Template.h"

namespace crowd::model {

/// A valid position with a heading, from the stage's extras. Frame of the stage asset.
struct Seat
{
    glm::vec3 position{0.0F}; ///< foot point, metres
    float headingRadians = 0.0F;
    float height = 0.0F; ///< of the seat plane above the foot point, metres
    int rank = 0;        ///< row, 0 in front
    int wedge = 0;
};

/// Triangles of one material of a stage, with the nodes' transforms already applied.
struct StageMesh
{
    int material = 0;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uv;
    std::vector<glm::vec4> colors; ///< linear; empty: white
    std::vector<std::uint32_t> indices;
};

/// Static geometry, read from glTF. Immutable once loaded, shared. Metres, Y up.
struct StageAsset
{
    std::string name;
    std::vector<StageMesh> meshes;
    std::vector<MaterialChoice> materials; ///< never empty
    std::vector<Image> images;
    std::vector<Seat> seats;
    std::size_t fileVertexCount = 0; ///< of the file's primitives, before any sharing or copying
    Bounds bounds;
    std::vector<Message> warnings;

    [[nodiscard]] std::size_t triangleCount() const
    {
        std::size_t triangles = 0;
        for (const StageMesh& mesh : meshes) {
            triangles += mesh.indices.size() / 3;
        }
        return triangles;
    }
};

using StagePtr = std::shared_ptr<const StageAsset>;

} // namespace crowd::model
