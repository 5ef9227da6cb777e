// SPDX-License-Identifier: MIT
#include "behavior/surface/SurfaceGround.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <recastnavigation/Recast.h>

namespace crowd::behavior {

namespace {

constexpr float kFloorShare = 0.25F;    ///< of the stages' area, from which a part of it is a floor
constexpr float kLowShare = 0.6F;       ///< of the stages' height, below which floors are
constexpr float kPlatformMetres = 2.0F; ///< so low a stage is all floor
constexpr float kEyeMetres = 0.9F;      ///< above a floor, from where one looks around
constexpr std::size_t kMostLooks = 9;   ///< from a part of it

/// Polygons that one gets to from each other.
struct Part
{
    double area = 0.0;              ///< as seen from above, m²
    double height = 0.0;            ///< mean, times the area
    std::vector<glm::vec3> middles; ///< of its polygons
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
        glm::vec3 sum = a;
        int corners = 1;
        for (; corners < m_mesh.nvp && corner[corners] != RC_MESH_NULL_IDX; ++corners) {
            sum += point(corner[corners]);
        }
        part.middles.push_back(sum / static_cast<float>(corners));
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
        m_parts.push_back(std::move(part));
    }

    const rcPolyMesh& m_mesh;
    std::vector<std::size_t> m_partOf;
    std::vector<Part> m_parts;
};

/// What one sees first that way: 1 the back of a triangle, -1 its front, 0 nothing.
int sideSeen(const TriangleSoup& soup, const glm::vec3& from, const glm::vec3& way)
{
    const auto vertex = [&soup](int index) {
        const float* v = &soup.vertices[static_cast<std::size_t>(index) * 3];
        return glm::vec3(v[0], v[1], v[2]);
    };
    float nearest = std::numeric_limits<float>::infinity();
    int side = 0;
    for (std::size_t i = 0; i + 2 < soup.triangles.size(); i += 3) { // after Möller and Trumbore
        const glm::vec3 a = vertex(soup.triangles[i]);
        const glm::vec3 toB = vertex(soup.triangles[i + 1]) - a;
        const glm::vec3 toC = vertex(soup.triangles[i + 2]) - a;
        const glm::vec3 across = glm::cross(way, toC);
        const float facing = glm::dot(toB, across); // above 0: its front
        if (facing == 0.0F) {
            continue;
        }
        const glm::vec3 off = from - a;
        const float u = glm::dot(off, across) / facing;
        const glm::vec3 turned = glm::cross(off, toB);
        const float v = glm::dot(way, turned) / facing;
        const float metres = glm::dot(toC, turned) / facing;
        if (u >= 0.0F && v >= 0.0F && u + v <= 1.0F && metres > 0.0F && metres < nearest) {
            nearest = metres;
            side = facing > 0.0F ? -1 : 1;
        }
    }
    return side;
}

/// Above him and on three sides at least there are walls made to be seen from outside.
bool isInSolid(const TriangleSoup& soup, const glm::vec3& from)
{
    if (sideSeen(soup, from, {0.0F, 1.0F, 0.0F}) <= 0) {
        return false;
    }
    int backs = 0;
    for (const glm::vec3& way : {glm::vec3(1.0F, 0.0F, 0.0F), glm::vec3(-1.0F, 0.0F, 0.0F),
                                 glm::vec3(0.0F, 0.0F, 1.0F), glm::vec3(0.0F, 0.0F, -1.0F)}) {
        backs += sideSeen(soup, from, way) > 0 ? 1 : 0;
    }
    return backs >= 3;
}

/// Most of a part, by what one sees from some of its polygons.
bool isInSolid(const TriangleSoup& soup, const Part& part)
{
    const std::size_t looks = std::min(kMostLooks, part.middles.size());
    std::size_t inside = 0;
    for (std::size_t i = 0; i < looks; ++i) {
        const glm::vec3& middle = part.middles[i * part.middles.size() / looks];
        inside += isInSolid(soup, middle + glm::vec3(0.0F, kEyeMetres, 0.0F)) ? 1 : 0;
    }
    return inside * 2 > looks;
}

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

std::vector<char> groundOf(const rcPolyMesh& mesh, const TriangleSoup& soup)
{
    const PartFinder finder(mesh);
    const std::vector<Part>& parts = finder.parts();
    const auto largest = std::ranges::max_element(parts, {}, &Part::area);
    std::vector<char> counts(parts.size(), 0);
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const bool isLinked = &parts[part] == &*largest;
        const bool isOwnFloor =
            !isLinked && isFloor(parts[part], soup.stages) && !isInSolid(soup, parts[part]);
        counts[part] = isLinked || isOwnFloor ? 1 : 0;
    }
    std::vector<char> isGround(static_cast<std::size_t>(mesh.npolys), 0);
    for (std::size_t polygon = 0; polygon < isGround.size(); ++polygon) {
        isGround[polygon] = counts[finder.partOf(polygon)];
    }
    return isGround;
}

} // namespace crowd::behavior
