// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "model/pick/ScreenArea.h"
#include "model/pick/ShownPeople.h"
#include "model/view/View.h"

namespace crowd::model {

/// Where an individual can be on screen, whatever way it faces and whatever keyframe is shown.
struct ScreenBox
{
    glm::vec2 low{0.0F}; ///< logical pixels
    glm::vec2 high{-1.0F};
    float nearDepth = 0.0F; ///< metres along the view axis, of the nearest corner

    [[nodiscard]] bool isOnScreen() const { return low.x <= high.x; }
};

/// People by the place they take on screen: projected boxes in a grid of cells, built by counting
/// sort. A query visits only the cells that its area touches, so its cost does not depend on how
/// many people there are elsewhere. Boxes do not depend on the shown time. Queries are thread-safe.
class ScreenIndex
{
public:
    void build(const ShownPeople& people, const View& view);

    [[nodiscard]] const ScreenBox& box(std::size_t row) const { return m_boxes[row]; }
    /// Rows whose box touches the box of the area, ascending.
    [[nodiscard]] std::vector<std::uint32_t> candidates(glm::dvec2 low, glm::dvec2 high) const;
    /// Entries that all queries so far looked at.
    [[nodiscard]] std::uint64_t visits() const { return m_visits.load(); }

private:
    struct CellRange
    {
        int x0, y0, x1, y1;
        [[nodiscard]] long cells() const { return static_cast<long>(x1 - x0 + 1) * (y1 - y0 + 1); }
    };
    [[nodiscard]] CellRange cellsOf(glm::vec2 low, glm::vec2 high) const;
    void placeInCells();

    int m_columns = 0;
    int m_rows = 0;
    std::vector<ScreenBox> m_boxes;         ///< by population row
    std::vector<std::uint32_t> m_cellStart; ///< cells + 1
    std::vector<std::uint32_t> m_entries;   ///< population rows, cell by cell
    std::vector<std::uint32_t> m_large;     ///< rows too large for the cells
    mutable std::atomic<std::uint64_t> m_visits{0};
};

} // namespace crowd::model
