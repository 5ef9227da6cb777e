// SPDX-License-Identifier: MIT
#include "model/pick/VisibleShapes.h"

#include <algorithm>
#include <limits>

#include "model/base/Parallel.h"

namespace crowd::model {

namespace {

constexpr int kStripPixels = 64;
constexpr int kMaxRaysEach = 128;
constexpr std::size_t kShapesPerChunk = 256;
constexpr std::uint32_t kNobody = 0xFFFFFFFFU;

/// Id-buffer of one strip: the index (into the ordered candidates) and nearness of the nearest
/// shape at each pixel.
class Strip
{
public:
    explicit Strip(const PixelRect& rect) : m_rect(rect)
    {
        const auto pixels =
            static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height());
        m_who.assign(pixels, kNobody);
        m_nearness.assign(pixels, -std::numeric_limits<float>::infinity());
    }

    [[nodiscard]] const PixelRect& rect() const { return m_rect; }
    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y - m_rect.y0) * static_cast<std::size_t>(m_rect.width()) +
               static_cast<std::size_t>(x - m_rect.x0);
    }
    [[nodiscard]] std::uint32_t who(int x, int y) const { return m_who[at(x, y)]; }
    [[nodiscard]] float nearness(int x, int y) const { return m_nearness[at(x, y)]; }

    /// `rows` ascend with the ids, so the smaller row wins a tie.
    void draw(std::uint32_t who, std::span<const std::uint32_t> rows, const ShownIndividual& shown,
              ShapeRaster& raster)
    {
        if (const auto extent = raster.extent(shown); extent && isHidden(*extent)) {
            return;
        }
        raster.walk(shown, m_rect, [&](int x, int y, float nearness) {
            const std::size_t pixel = at(x, y);
            const bool isNearer = nearness > m_nearness[pixel];
            const bool isTie = nearness == m_nearness[pixel] && m_who[pixel] != kNobody &&
                               rows[who] < rows[m_who[pixel]];
            if (isNearer || isTie) {
                m_nearness[pixel] = nearness;
                m_who[pixel] = who;
            }
            return true;
        });
    }

private:
    [[nodiscard]] bool isHidden(const ShapeRaster::Extent& extent) const
    {
        const PixelRect in = extent.rect.clipped(m_rect);
        for (int y = in.y0; y < in.y1; ++y) {
            for (int x = in.x0; x < in.x1; ++x) {
                if (m_nearness[at(x, y)] <= extent.nearness) {
                    return false;
                }
            }
        }
        return true;
    }

    PixelRect m_rect;
    std::vector<std::uint32_t> m_who;
    std::vector<float> m_nearness;
};

/// Candidates of one strip, nearest box first, so that later ones are mostly found hidden.
std::vector<std::uint32_t> nearestFirst(const ScreenIndex& index,
                                        std::span<const std::uint32_t> candidates,
                                        const PixelRect& rect)
{
    std::vector<std::uint32_t> rows;
    for (const std::uint32_t row : candidates) {
        const ScreenBox& box = index.box(row);
        if (box.low.y <= static_cast<float>(rect.y1) && box.high.y >= static_cast<float>(rect.y0)) {
            rows.push_back(row);
        }
    }
    std::ranges::sort(rows, [&](std::uint32_t a, std::uint32_t b) {
        const float depthA = index.box(a).nearDepth;
        const float depthB = index.box(b).nearDepth;
        return depthA != depthB ? depthA < depthB : a < b;
    });
    return rows;
}

bool isPixelBlocked(const View& view, const StageRays& stage, int x, int y, float depth)
{
    const Ray ray = view.rayThrough({static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F});
    const glm::vec3 forward = view.camera().forward();
    const float start = glm::dot(ray.origin - view.camera().position, forward);
    const float distance = (depth - start) / glm::dot(ray.direction, forward);
    return stage.isBlocked(ray.origin, ray.origin + ray.direction * distance);
}

/// Those of the strip's shapes of which the stage leaves a pixel of the area to be seen.
std::vector<std::uint32_t> seenInStrip(const Strip& strip, std::span<const std::uint32_t> rows,
                                       const AreaPixels& area, const ShapeRaster& raster,
                                       const StageRays& stage)
{
    const auto forEachPixel = [&](const auto& visit) {
        for (int y = strip.rect().y0; y < strip.rect().y1; ++y) {
            for (int x = strip.rect().x0; x < strip.rect().x1; ++x) {
                if (strip.who(x, y) != kNobody && area.contains(x, y)) {
                    visit(x, y, strip.who(x, y));
                }
            }
        }
    };
    std::vector<int> pixels(rows.size(), 0);
    forEachPixel([&](int, int, std::uint32_t who) { ++pixels[who]; });
    std::vector<int> visited(rows.size(), 0);
    std::vector<bool> isSeen(rows.size(), false);
    forEachPixel([&](int x, int y, std::uint32_t who) {
        const int stride = 1 + pixels[who] / kMaxRaysEach;
        if (!isSeen[who] && visited[who]++ % stride == 0) {
            isSeen[who] =
                !isPixelBlocked(raster.view(), stage, x, y, raster.depthOf(strip.nearness(x, y)));
        }
    });
    std::vector<std::uint32_t> seen;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (isSeen[i]) {
            seen.push_back(rows[i]);
        }
    }
    return seen;
}

std::vector<std::uint32_t> drawStrip(const PixelRect& rect, const ShownPeople& people,
                                     const ScreenIndex& index,
                                     std::span<const std::uint32_t> candidates,
                                     const AreaPixels& area, const View& view,
                                     const StageRays& stage)
{
    const std::vector<std::uint32_t> rows = nearestFirst(index, candidates, rect);
    Strip strip(rect);
    ShapeRaster raster(view);
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
        const ShownIndividual shown = people.at(rows[i]);
        if (shown.clip != nullptr) {
            strip.draw(i, rows, shown, raster);
        }
    }
    return seenInStrip(strip, rows, area, raster, stage);
}

/// The pixel that a place on the screen lies in; of what is no number, far out.
int whole(double place)
{
    constexpr double kFar = 1.0e6;
    return static_cast<int>(std::floor(place > -kFar ? std::min(place, kFar) : -kFar));
}

} // namespace

AreaPixels::AreaPixels(const ScreenArea& area, const View& view)
    : m_area(area), m_middle(whole(area.center().x), whole(area.center().y))
{
    const PixelRect screen{0, 0, static_cast<int>(std::ceil(view.size().x)),
                           static_cast<int>(std::ceil(view.size().y))};
    m_rect = PixelRect{whole(area.low().x), whole(area.low().y), whole(area.high().x) + 1,
                       whole(area.high().y) + 1}
                 .clipped(screen);
    if (area.isPolygon()) {
        fillPolygon(area.corners());
    }
}

/// Row by row: where edges cross the middle of a row of pixels, the winding number changes.
void AreaPixels::fillPolygon(const std::vector<glm::dvec2>& corners)
{
    const int width = m_rect.width();
    m_isInside.assign(static_cast<std::size_t>(std::max(0, width * m_rect.height())), 0);
    std::vector<std::vector<Crossing>> rows(static_cast<std::size_t>(std::max(0, m_rect.height())));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 a = corners[i];
        const glm::dvec2 b = corners[i + 1 < corners.size() ? i + 1 : 0];
        const double top = std::min(a.y, b.y);
        const double bottom = std::max(a.y, b.y);
        const int first = std::max(m_rect.y0, static_cast<int>(std::ceil(top - 0.5)));
        for (int y = first; y < m_rect.y1 && y + 0.5 < bottom; ++y) {
            const double x = a.x + (b.x - a.x) * ((y + 0.5 - a.y) / (b.y - a.y));
            rows[static_cast<std::size_t>(y - m_rect.y0)].push_back({x, b.y > a.y ? 1 : -1});
        }
    }
    for (std::size_t y = 0; y < rows.size(); ++y) {
        fillRow(rows[y], &m_isInside[y * static_cast<std::size_t>(width)]);
    }
}

void AreaPixels::fillRow(std::vector<Crossing>& crossings, char* row) const
{
    std::ranges::sort(crossings, {}, &Crossing::x);
    int turns = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        turns += crossings[i].direction;
        if (turns != 0) {
            const double from = std::max(crossings[i].x, static_cast<double>(m_rect.x0));
            const double to = std::min(crossings[i + 1].x, static_cast<double>(m_rect.x1));
            for (int x = static_cast<int>(std::ceil(from - 0.5)); x + 0.5 < to; ++x) {
                row[x - m_rect.x0] = 1;
            }
        }
    }
}

std::vector<std::uint32_t> visibleShapes(const ShownPeople& people, const ScreenIndex& index,
                                         std::span<const std::uint32_t> candidates,
                                         const AreaPixels& area, const View& view,
                                         const StageRays& stage)
{
    const PixelRect& rect = area.rect();
    if (rect.isEmpty() || candidates.empty()) {
        return {};
    }
    const auto strips = static_cast<std::size_t>((rect.height() + kStripPixels - 1) / kStripPixels);
    std::vector<std::vector<std::uint32_t>> found(strips);
    parallelFor(strips, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int top = rect.y0 + static_cast<int>(i) * kStripPixels;
            const PixelRect strip{rect.x0, top, rect.x1, std::min(top + kStripPixels, rect.y1)};
            found[i] = drawStrip(strip, people, index, candidates, area, view, stage);
        }
    });
    std::vector<std::uint32_t> all;
    for (const auto& rows : found) {
        all.insert(all.end(), rows.begin(), rows.end());
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::vector<std::uint32_t> touchingShapes(const ShownPeople& people, const ScreenIndex& index,
                                          std::span<const std::uint32_t> candidates,
                                          const ScreenArea& area, const View& view)
{
    const AreaPixels pixels(area, view);
    std::vector<char> isIn(candidates.size(), 0);
    parallelFor(candidates.size(), kShapesPerChunk, [&](std::size_t begin, std::size_t end) {
        ShapeRaster raster(view);
        for (std::size_t i = begin; i < end; ++i) {
            const ScreenBox& box = index.box(candidates[i]);
            const glm::dvec2 low(box.low);
            const glm::dvec2 high(box.high);
            if (area.containsBox(low, high)) {
                isIn[i] = 1;
            } else if (area.touches(low, high)) {
                const ShownIndividual shown = people.at(candidates[i]);
                raster.walk(shown, pixels.rect(), [&](int x, int y, float) {
                    isIn[i] = pixels.contains(x, y) ? 1 : 0;
                    return isIn[i] == 0;
                });
            }
        }
    });
    std::vector<std::uint32_t> rows;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (isIn[i] != 0) {
            rows.push_back(candidates[i]);
        }
    }
    return rows;
}

} // namespace crowd::model
