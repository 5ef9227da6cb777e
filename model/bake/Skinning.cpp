// SPDX-License-Identifier: MIT
#include "model/bake/Skinning.h"

#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>

namespace crowd::model {

namespace {

glm::mat4 blend(const Mesh& mesh, std::size_t vertex, std::span<const glm::mat4> bones)
{
    const auto influences = static_cast<std::size_t>(mesh.influencesPerVertex);
    const std::uint16_t* index = mesh.bones.data() + vertex * influences;
    const float* weight = mesh.weights.data() + vertex * influences;
    if (weight[0] == 1.0F) {
        return bones[index[0]];
    }
    glm::mat4 sum = bones[index[0]] * weight[0];
    for (std::size_t i = 1; i < influences; ++i) {
        if (weight[i] != 0.0F) {
            const glm::mat4& bone = bones[index[i]];
            sum[0] += bone[0] * weight[i];
            sum[1] += bone[1] * weight[i];
            sum[2] += bone[2] * weight[i];
            sum[3] += bone[3] * weight[i];
        }
    }
    return sum;
}

glm::vec3 turnNormal(const glm::mat4& matrix, const glm::vec3& normal)
{
    const glm::vec3 x(matrix[0]);
    const glm::vec3 y(matrix[1]);
    const glm::vec3 z(matrix[2]);
    const glm::vec3 yz = glm::cross(y, z);
    glm::vec3 turned = yz * normal.x + glm::cross(z, x) * normal.y + glm::cross(x, y) * normal.z;
    if (glm::dot(x, yz) < 0.0F) {
        turned = -turned;
    }
    const float length2 = glm::dot(turned, turned);
    return length2 > 0.0F ? turned * (1.0F / std::sqrt(length2)) : normal;
}

} // namespace

void skin(const Mesh& mesh, std::span<const glm::mat4> bones, std::span<glm::vec3> positions,
          std::span<glm::vec3> normals)
{
    assert(positions.size() == mesh.positions.size());
    assert(normals.empty() || normals.size() == mesh.normals.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const glm::mat4 matrix = blend(mesh, v, bones);
        const glm::vec3& p = mesh.positions[v];
        positions[v] = glm::vec3(matrix[0] * p.x + matrix[1] * p.y + (matrix[2] * p.z + matrix[3]));
        if (!normals.empty()) {
            normals[v] = turnNormal(matrix, mesh.normals[v]);
        }
    }
}

} // namespace crowd::model
