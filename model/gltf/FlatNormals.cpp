// SPDX-License-Identifier: MIT
#include "model/gltf/FlatNormals.h"

#include <cmath>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace crowd::model::gltf {

namespace {

constexpr float kSameDirection = 0.99995F; ///< cosine, half a degree

class FlatShader
{
public:
    explicit FlatShader(Mesh& mesh) : m_mesh(mesh) {}

    void run(const FlatRun& run)
    {
        for (std::size_t i = run.firstIndex; i + 2 < run.endIndex; i += 3) {
            const glm::vec3 normal = faceNormal(i, run.isMirrored);
            for (std::size_t corner = i; corner < i + 3; ++corner) {
                m_mesh.indices[corner] = vertexWith(m_mesh.indices[corner], normal);
            }
        }
    }

    /// Vertices of no triangle or only of flat ones.
    void finish()
    {
        for (glm::vec3& normal : m_mesh.normals) {
            if (normal == glm::vec3(0.0F)) {
                normal = {0.0F, 1.0F, 0.0F};
            }
        }
    }

private:
    glm::vec3 faceNormal(std::size_t i, bool isMirrored) const
    {
        const glm::vec3& a = m_mesh.positions[m_mesh.indices[i]];
        const glm::vec3& b = m_mesh.positions[m_mesh.indices[i + 1]];
        const glm::vec3& c = m_mesh.positions[m_mesh.indices[i + 2]];
        const glm::vec3 across = glm::cross(b - a, c - a) * (isMirrored ? -1.0F : 1.0F);
        const float length = glm::length(across);
        return length > 0.0F ? across / length : glm::vec3(0.0F, 1.0F, 0.0F);
    }

    /// The vertex itself, one of its copies, or a new copy with this normal.
    std::uint32_t vertexWith(std::uint32_t vertex, const glm::vec3& normal)
    {
        if (m_mesh.normals[vertex] == glm::vec3(0.0F)) {
            m_mesh.normals[vertex] = normal;
        }
        std::uint32_t at = vertex;
        while (glm::dot(m_mesh.normals[at], normal) < kSameDirection) {
            const auto next = m_nextCopy.find(at);
            if (next == m_nextCopy.end()) {
                m_nextCopy[at] = copy(vertex, normal);
                return m_nextCopy[at];
            }
            at = next->second;
        }
        return at;
    }

    std::uint32_t copy(std::uint32_t vertex, const glm::vec3& normal)
    {
        const auto influences = static_cast<std::size_t>(m_mesh.influencesPerVertex);
        m_mesh.positions.push_back(m_mesh.positions[vertex]);
        m_mesh.normals.push_back(normal);
        m_mesh.uv.push_back(m_mesh.uv[vertex]);
        m_mesh.colors.push_back(m_mesh.colors[vertex]);
        for (std::size_t i = 0; i < influences; ++i) {
            m_mesh.bones.push_back(m_mesh.bones[vertex * influences + i]);
            m_mesh.weights.push_back(m_mesh.weights[vertex * influences + i]);
        }
        return static_cast<std::uint32_t>(m_mesh.positions.size() - 1);
    }

    Mesh& m_mesh;
    std::unordered_map<std::uint32_t, std::uint32_t> m_nextCopy;
};

} // namespace

void computeFlatNormals(Mesh& mesh, const std::vector<FlatRun>& runs)
{
    FlatShader shader(mesh);
    for (const FlatRun& run : runs) {
        shader.run(run);
    }
    if (!runs.empty()) {
        shader.finish();
    }
}

} // namespace crowd::model::gltf
