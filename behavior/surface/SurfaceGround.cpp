// SPDX-License-Identifier: MIT
#include "behavior/surface/SurfaceGround.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

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

/// Numbers the polygons, tile by tile, and finds what hangs together.
class PartFinder
{
public:
    explicit PartFinder(const dtNavMesh& mesh) : m_mesh(mesh)
    {
        std::size_t count = 0;
        for (int i = 0; i < mesh.getMaxTiles(); ++i) {
            const dtMeshTile* tile = mesh.getTile(i);
            m_first.push_back(count);
            count +=
                tile->header == nullptr ? 0 : static_cast<std::size_t>(tile->header->polyCount);
        }
        m_partOf.assign(count, kNone);
        for (int i = 0; i < mesh.getMaxTiles(); ++i) {
            const dtMeshTile* tile = mesh.getTile(i);
            for (int p = 0; tile->header != nullptr && p < tile->header->polyCount; ++p) {
                const dtPolyRef polygon = mesh.getPolyRefBase(tile) | static_cast<dtPolyRef>(p);
                if (m_partOf[numberOf(polygon)] == kNone) {
                    spread(polygon);
                }
            }
        }
    }
    [[nodiscard]] const std::vector<Part>& parts() const { return m_parts; }
    [[nodiscard]] const std::vector<std::size_t>& partOf() const { return m_partOf; }
    [[nodiscard]] const std::vector<std::size_t>& first() const { return m_first; }

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    [[nodiscard]] std::size_t numberOf(dtPolyRef polygon) const
    {
        return m_first[m_mesh.decodePolyIdTile(polygon)] + m_mesh.decodePolyIdPoly(polygon);
    }
    static void add(const dtMeshTile& tile, const dtPoly& polygon, Part& part)
    {
        const auto point = [&tile, &polygon](int i) {
            const float* v = &tile.verts[polygon.verts[i] * 3];
            return glm::vec3(v[0], v[1], v[2]);
        };
        const glm::vec3 a = point(0);
        glm::vec3 sum = a;
        for (int i = 1; i < polygon.vertCount; ++i) {
            sum += point(i);
        }
        part.middles.push_back(sum / static_cast<float>(polygon.vertCount));
        for (int i = 2; i < polygon.vertCount; ++i) {
            const glm::vec3 b = point(i - 1);
            const glm::vec3 c = point(i);
            const double area = 0.5 * std::fabs(static_cast<double>((b.x - a.x) * (c.z - a.z) -
                                                                    (b.z - a.z) * (c.x - a.x)));
            part.area += area;
            part.height += area * static_cast<double>(a.y + b.y + c.y) / 3.0;
        }
    }
    void spread(dtPolyRef first)
    {
        const std::size_t index = m_parts.size();
        Part part;
        std::vector<dtPolyRef> open{first};
        m_partOf[numberOf(first)] = index;
        while (!open.empty()) {
            const dtMeshTile* tile = nullptr;
            const dtPoly* polygon = nullptr;
            m_mesh.getTileAndPolyByRefUnsafe(open.back(), &tile, &polygon);
            open.pop_back();
            add(*tile, *polygon, part);
            for (unsigned i = polygon->firstLink; i != DT_NULL_LINK; i = tile->links[i].next) {
                const dtPolyRef next = tile->links[i].ref;
                if (next != 0 && m_partOf[numberOf(next)] == kNone) {
                    m_partOf[numberOf(next)] = index;
                    open.push_back(next);
                }
            }
        }
        m_parts.push_back(std::move(part));
    }

    const dtNavMesh& m_mesh;
    std::vector<std::size_t> m_first;
    std::vector<std::size_t> m_partOf; ///< by number of the polygon
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

/// A polygon as Detour keeps it in detail: its own corners first, then those of its own heights.
void addTriangles(const dtMeshTile& tile, int number, float lower,
                  std::vector<std::array<glm::vec3, 3>>& into)
{
    const dtPoly& polygon = tile.polys[number];
    const dtPolyDetail& detail = tile.detailMeshes[number];
    for (unsigned t = 0; t < detail.triCount; ++t) {
        const unsigned char* corners = &tile.detailTris[(detail.triBase + t) * 4];
        std::array<glm::vec3, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const float* v =
                corners[k] < polygon.vertCount
                    ? &tile.verts[polygon.verts[corners[k]] * 3]
                    : &tile.detailVerts[(detail.vertBase + corners[k] - polygon.vertCount) * 3];
            triangle[k] = {v[0], v[1] - lower, v[2]};
        }
        into.push_back(triangle);
    }
}

} // namespace

SurfaceGround::SurfaceGround(const dtNavMesh& mesh, const TriangleSoup& soup) : m_mesh(&mesh)
{
    const PartFinder finder(mesh);
    m_first = finder.first();
    const std::vector<Part>& parts = finder.parts();
    const auto largest = std::ranges::max_element(parts, {}, &Part::area);
    std::vector<char> counts(parts.size(), 0);
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const bool isLinked = &parts[part] == &*largest;
        const bool isOwnFloor =
            !isLinked && isFloor(parts[part], soup.stages) && !isInSolid(soup, parts[part]);
        counts[part] = isLinked || isOwnFloor ? 1 : 0;
    }
    m_isGround.reserve(finder.partOf().size());
    for (const std::size_t part : finder.partOf()) {
        m_isGround.push_back(counts[part]);
    }
}

bool SurfaceGround::holds(dtPolyRef polygon) const
{
    return m_mesh != nullptr && m_isGround[m_first[m_mesh->decodePolyIdTile(polygon)] +
                                           m_mesh->decodePolyIdPoly(polygon)] != 0;
}

std::vector<std::array<glm::vec3, 3>> SurfaceGround::triangles(float cellHeight) const
{
    std::vector<std::array<glm::vec3, 3>> found;
    for (int i = 0; m_mesh != nullptr && i < m_mesh->getMaxTiles(); ++i) {
        const dtMeshTile* tile = m_mesh->getTile(i);
        for (int p = 0; tile->header != nullptr && p < tile->header->polyCount; ++p) {
            if (m_isGround[m_first[static_cast<std::size_t>(i)] + static_cast<std::size_t>(p)] !=
                0) {
                addTriangles(*tile, p, cellHeight, found);
            }
        }
    }
    return found;
}

} // namespace crowd::behavior
