// SPDX-License-Identifier: MIT
#include "behavior/surface/SurfaceGround.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/vec3.hpp>
#include <recastnavigation/Recast.h>

namespace crowd::behavior {

namespace {

constexpr float kFloorShare = 0.25F;    ///< of the stages' area, from which a part of it is a floor
constexpr float kLowShare = 0.6F;       ///< of the stages' height, below which floors are
constexpr float kPlatformMetres = 2.0F; ///< so low a stage is all floor

/// Polygons that one gets to from each other.
struct Part
{
    double area = 0.0;   ///< as seen from above, m²
    double height = 0.0; ///< mean, times the area
};

class PartFinder
{
public:
    explicit PartFinder(const rcPolyMesh& mesh)
        : m_mesh(mesh), m_partOf(static_cast<std::size_t>(mesh.npolys), kNone)
    {
        for (int polygon = 0; polygon < mesh.npolys; ++polygon) {
            if (m_partOf[static_cast<std::size_t>(polygon)] == kNone) {
                spread(polygon);
            }
        }
    }
    [[nodiscard]] const std::vector<Part>& parts() const { return m_parts; }
    [[nodiscard]] std::size_t partOf(std::size_t polygon) const { return m_partOf[polygon]; }

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    [[nodiscard]] const unsigned short* corners(int polygon) const
    {
        return &m_mesh.polys[polygon * 2 * m_mesh.nvp];
    }
    [[nodiscard]] glm::vec3 point(unsigned short vertex) const
    {
        const unsigned short* v = &m_mesh.verts[vertex * 3];
        return {m_mesh.bmin[0] + static_cast<float>(v[0]) * m_mesh.cs,
                m_mesh.bmin[1] + static_cast<float>(v[1]) * m_mesh.ch,
                m_mesh.bmin[2] + static_cast<float>(v[2]) * m_mesh.cs};
    }
    void add(int polygon, Part& part) const
    {
        const unsigned short* corner = corners(polygon);
        const glm::vec3 a = point(corner[0]);
        for (int i = 2; i < m_mesh.nvp && corner[i] != RC_MESH_NULL_IDX; ++i) {
            const glm::vec3 b = point(corner[i - 1]);
            const glm::vec3 c = point(corner[i]);
            const double area = 0.5 * std::fabs(static_cast<double>((b.x - a.x) * (c.z - a.z) -
                                                                    (b.z - a.z) * (c.x - a.x)));
            part.area += area;
            part.height += area * static_cast<double>(a.y + b.y + c.y) / 3.0;
        }
    }
    void spread(int first)
    {
        const std::size_t index = m_parts.size();
        Part part;
        std::vector<int> open{first};
        m_partOf[static_cast<std::size_t>(first)] = index;
        while (!open.empty()) {
            const int polygon = open.back();
            open.pop_back();
            add(polygon, part);
            for (int edge = 0; edge < m_mesh.nvp; ++edge) {
                const unsigned short next = corners(polygon)[m_mesh.nvp + edge];
                if (corners(polygon)[edge] != RC_MESH_NULL_IDX && next != RC_MESH_NULL_IDX &&
                    m_partOf[next] == kNone) {
                    m_partOf[next] = index;
                    open.push_back(next);
                }
            }
        }
        m_parts.push_back(part);
    }

    const rcPolyMesh& m_mesh;
    std::vector<std::size_t> m_partOf;
    std::vector<Part> m_parts;
};

bool isFloor(const Part& part, const model::Bounds& stages)
{
    if (stages.isEmpty() || part.area <= 0.0) {
        return false;
    }
    const glm::vec3 size = stages.high - stages.low;
    const double footprint = static_cast<double>(size.x) * static_cast<double>(size.z);
    const double above = part.height / part.area - static_cast<double>(stages.low.y);
    return part.area >= static_cast<double>(kFloorShare) * footprint &&
           above <= static_cast<double>(std::max(kPlatformMetres, kLowShare * size.y));
}

} // namespace

std::vector<char> groundOf(const rcPolyMesh& mesh, const model::Bounds& stages)
{
    const PartFinder finder(mesh);
    const std::vector<Part>& parts = finder.parts();
    const auto largest = std::ranges::max_element(parts, {}, &Part::area);
    std::vector<char> isGround(static_cast<std::size_t>(mesh.npolys), 0);
    for (std::size_t polygon = 0; polygon < isGround.size(); ++polygon) {
        const std::size_t part = finder.partOf(polygon);
        const bool counts = &parts[part] == &*largest || isFloor(parts[part], stages);
        isGround[polygon] = counts ? 1 : 0;
    }
    return isGround;
}

} // namespace crowd::behavior
