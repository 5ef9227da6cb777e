// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/pick/ScreenIndex.h"
#include "model/pick/ShapeRaster.h"
#include "model/pick/StageRays.h"

namespace crowd::model {

/// The pixels of an area: those whose centres lie inside, and always the one under its middle, so
/// that an area smaller than a pixel is not empty (a polygon may be). Clipped to the view.
class AreaPixels
{
public:
    AreaPixels(const ScreenArea& area, const View& view);

    [[nodiscard]] const PixelRect& rect() const { return m_rect; }
    [[nodiscard]] bool contains(int x, int y) const
    {
        if (m_area.isPolygon()) {
            return m_isInside[static_cast<std::size_t>((y - m_rect.y0) * m_rect.width() + x -
                                                       m_rect.x0)] != 0;
        }
        return m_area.contains({x + 0.5, y + 0.5}) || (x == m_middle.x && y == m_middle.y);
    }

private:
    /// Where an edge meets a row of pixels, and whether it goes down (1) or up (-1).
    struct Crossing
    {
        double x;
        int direction;
    };
    void fillPolygon(const std::vector<glm::dvec2>& corners);
    void fillRow(std::vector<Crossing>& crossings, char* row) const;

    ScreenArea m_area;
    glm::ivec2 m_middle;
    PixelRect m_rect;
    std::vector<char> m_isInside; ///< of a polygon: by pixel of the rectangle
};

/// Which of the candidates (rows) show at least one pixel inside the area. Resolves people against
/// each other in an id-buffer, strip by strip on all cores, and then against the stage with at most
/// 128 rays each and strip. Ascending rows; the same for any number of threads.
[[nodiscard]] std::vector<std::uint32_t> visibleShapes(const ShownPeople& people,
                                                       const ScreenIndex& index,
                                                       std::span<const std::uint32_t> candidates,
                                                       const AreaPixels& area, const View& view,
                                                       const StageRays& stage);

/// Which of the candidates have at least one pixel inside the area, hidden or not.
[[nodiscard]] std::vector<std::uint32_t> touchingShapes(const ShownPeople& people,
                                                        const ScreenIndex& index,
                                                        std::span<const std::uint32_t> candidates,
                                                        const ScreenArea& area, const View& view);

} // namespace crowd::model
