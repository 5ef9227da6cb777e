// SPDX-License-Identifier: MIT
#include "model/pick/ScreenIndex.h"

#include <algorithm>
#include <cmath>

#include "model/base/Parallel.h"

namespace crowd::model {

namespace {

constexpr float kCellPixels = 32.0F;
constexpr long kMaxCellsEach = 64; ///< larger boxes go into a list of their own
constexpr std::size_t kRowsPerChunk = 2048;

/// Screen box of an upright box in the world. Corners are sums of three edge vectors in clip space,
/// which saves most of the multiplications.
class BoxProjector
{
public:
    explicit BoxProjector(const View& view) : m_view(view), m_matrix(view.viewProjection())
    {
        m_toEye = -glm::vec4(view.viewMatrix()[0].z, view.viewMatrix()[1].z, view.viewMatrix()[2].z,
                             view.viewMatrix()[3].z);
    }

    [[nodiscard]] ScreenBox project(const glm::vec3& foot, float radius, float low,
                                    float high) const
    {
        const glm::vec3 origin = foot + glm::vec3(-radius, low, -radius);
        const float centerDepth = depthOf(foot + glm::vec3(0.0F, 0.5F * (low + high), 0.0F));
        const float reach = std::sqrt(2.0F * radius * radius + 0.25F * (high - low) * (high - low));
        if (centerDepth + reach < m_view.nearPlane()) {
            return {};
        }
        if (centerDepth - reach < m_view.nearPlane()) {
            // Around the eye: anywhere on screen.
            return {glm::vec2(0.0F), m_view.size(), m_view.nearPlane()};
        }
        return projectCorners(origin, 2.0F * radius, high - low, centerDepth - reach);
    }

private:
    [[nodiscard]] float depthOf(const glm::vec3& point) const
    {
        return glm::dot(m_toEye, glm::vec4(point, 1.0F));
    }
    [[nodiscard]] ScreenBox projectCorners(const glm::vec3& origin, float width, float height,
                                           float nearDepth) const
    {
        const glm::vec4 base = m_matrix * glm::vec4(origin, 1.0F);
        const glm::vec4 x = m_matrix[0] * width;
        const glm::vec4 y = m_matrix[1] * height;
        const glm::vec4 z = m_matrix[2] * width;
        glm::vec2 low(1.0e30F);
        glm::vec2 high(-1.0e30F);
        const std::array<glm::vec4, 4> ring{base, base + x, base + z, base + x + z};
        for (const glm::vec4& bottom : ring) {
            for (const glm::vec4& corner : {bottom, bottom + y}) {
                const glm::vec2 at = glm::vec2(corner) / corner.w;
                low = glm::min(low, at);
                high = glm::max(high, at);
            }
        }
        const glm::vec2 half = m_view.size() * 0.5F;
        const ScreenBox box{{(low.x + 1.0F) * half.x, (1.0F - high.y) * half.y},
                            {(high.x + 1.0F) * half.x, (1.0F - low.y) * half.y},
                            nearDepth};
        const bool isOff = box.high.x < 0.0F || box.high.y < 0.0F || box.low.x > m_view.size().x ||
                           box.low.y > m_view.size().y;
        return isOff ? ScreenBox{} : box;
    }

    const View& m_view;
    glm::mat4 m_matrix;
    glm::vec4 m_toEye{0.0F};
};

} // namespace

void ScreenIndex::build(const ShownPeople& people, const View& view)
{
    m_columns = std::max(1, static_cast<int>(std::ceil(view.size().x / kCellPixels)));
    m_rows = std::max(1, static_cast<int>(std::ceil(view.size().y / kCellPixels)));
    m_boxes.assign(people.size(), {});
    const BoxProjector projector(view);
    if (people.size() > 0) {
        const Population& rows = people.frame()->population;
        const auto positions = rows.column(columns::position);
        const auto heights = rows.column(columns::height);
        const auto girths = rows.column(columns::girth);
        parallelFor(people.size(), kRowsPerChunk, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row) {
                if (const ShownClip* clip = people.clipAt(row)) {
                    const float lift = people.liftAt(row, *clip);
                    m_boxes[row] = projector.project(positions[row], clip->radius * girths[row],
                                                     clip->low * heights[row] + lift,
                                                     clip->high * heights[row] + lift);
                }
            }
        });
    }
    placeInCells();
}

ScreenIndex::CellRange ScreenIndex::cellsOf(glm::vec2 low, glm::vec2 high) const
{
    const auto cell = [](float pixel, int count) {
        const float clamped = std::clamp(pixel / kCellPixels, 0.0F, static_cast<float>(count - 1));
        return static_cast<int>(clamped);
    };
    return {cell(low.x, m_columns), cell(low.y, m_rows), cell(high.x, m_columns),
            cell(high.y, m_rows)};
}

void ScreenIndex::placeInCells()
{
    const std::size_t cells =
        static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows);
    m_cellStart.assign(cells + 1, 0);
    m_large.clear();
    const auto forEachCell = [&](const CellRange& range, const auto& visit) {
        for (int y = range.y0; y <= range.y1; ++y) {
            for (int x = range.x0; x <= range.x1; ++x) {
                visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(m_columns) +
                      static_cast<std::size_t>(x));
            }
        }
    };
    for (std::size_t row = 0; row < m_boxes.size(); ++row) {
        if (!m_boxes[row].isOnScreen()) {
            continue;
        }
        const CellRange range = cellsOf(m_boxes[row].low, m_boxes[row].high);
        if (range.cells() > kMaxCellsEach) {
            m_large.push_back(static_cast<std::uint32_t>(row));
        } else {
            forEachCell(range, [&](std::size_t cell) { ++m_cellStart[cell + 1]; });
        }
    }
    for (std::size_t cell = 0; cell < cells; ++cell) {
        m_cellStart[cell + 1] += m_cellStart[cell];
    }
    m_entries.resize(m_cellStart[cells]);
    std::vector<std::uint32_t> next(m_cellStart.begin(), m_cellStart.end() - 1);
    for (std::size_t row = 0; row < m_boxes.size(); ++row) {
        if (!m_boxes[row].isOnScreen()) {
            continue;
        }
        const CellRange range = cellsOf(m_boxes[row].low, m_boxes[row].high);
        if (range.cells() <= kMaxCellsEach) {
            forEachCell(range, [&](std::size_t cell) {
                m_entries[next[cell]++] = static_cast<std::uint32_t>(row);
            });
        }
    }
}

std::vector<std::uint32_t> ScreenIndex::candidates(glm::dvec2 low, glm::dvec2 high) const
{
    std::vector<std::uint32_t> found;
    const glm::vec2 from(low);
    const glm::vec2 to(high);
    const auto touches = [&](const ScreenBox& box) {
        return box.low.x <= to.x && box.high.x >= from.x && box.low.y <= to.y &&
               box.high.y >= from.y;
    };
    for (const std::uint32_t row : m_large) {
        if (touches(m_boxes[row])) {
            found.push_back(row);
        }
    }
    std::uint64_t visits = m_large.size();
    if (m_columns > 0 && !m_cellStart.empty()) {
        const CellRange range = cellsOf(from, to);
        for (int y = range.y0; y <= range.y1; ++y) {
            for (int x = range.x0; x <= range.x1; ++x) {
                const std::size_t cell =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(m_columns) +
                    static_cast<std::size_t>(x);
                for (std::uint32_t i = m_cellStart[cell]; i < m_cellStart[cell + 1]; ++i) {
                    const ScreenBox& box = m_boxes[m_entries[i]];
                    // A box in several cells is reported by the first one that the area touches.
                    const CellRange own = cellsOf(box.low, box.high);
                    if (std::max(own.x0, range.x0) == x && std::max(own.y0, range.y0) == y &&
                        touches(box)) {
                        found.push_back(m_entries[i]);
                    }
                }
                visits += m_cellStart[cell + 1] - m_cellStart[cell];
            }
        }
    }
    m_visits += visits;
    std::ranges::sort(found);
    return found;
}

} // namespace crowd::model
