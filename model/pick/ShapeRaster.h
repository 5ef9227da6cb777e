// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "model/pick/ScreenArea.h"
#include "model/pick/ShownPeople.h"
#include "model/view/View.h"

namespace crowd::model {

/// Logical pixels x0..x1-1, y0..y1-1.
struct PixelRect
{
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    [[nodiscard]] int width() const { return std::max(0, x1 - x0); }
    [[nodiscard]] int height() const { return std::max(0, y1 - y0); }
    [[nodiscard]] bool isEmpty() const { return width() == 0 || height() == 0; }
    [[nodiscard]] PixelRect clipped(const PixelRect& to) const
    {
        return {std::max(x0, to.x0), std::max(y0, to.y0), std::min(x1, to.x1), std::min(y1, to.y1)};
    }
};

/// The pixels of the shape of one individual on screen: its keyframe's triangles, sampled at the
/// centres of logical pixels. Coarser levels when it is small, a box under 8 pixels.
/// Nearness grows towards the eye and is affine on screen: 1 / depth, or -depth without
/// perspective. Holds scratch memory: one per thread.
class ShapeRaster
{
public:
    explicit ShapeRaster(const View& view);

    /// Calls pixel(x, y, nearness) for each covered pixel in `rect`, some several times; it returns
    /// whether to go on.
    template<class Pixel>
    void walk(const ShownIndividual& shown, const PixelRect& rect, Pixel&& pixel);

    /// Where the shape's keyframe can be on screen, with the nearness of its nearest point; nothing
    /// when part of it is nearer than the near plane.
    struct Extent
    {
        PixelRect rect;
        float nearness = 0.0F;
    };
    [[nodiscard]] std::optional<Extent> extent(const ShownIndividual& shown) const;

    /// Projected height in logical pixels.
    [[nodiscard]] float heightPixels(const ShownIndividual& shown) const;
    /// Index into BakedClip::levels; -1: the box stands for the shape.
    [[nodiscard]] int level(const ShownIndividual& shown) const;
    [[nodiscard]] float nearnessOf(float depth) const
    {
        return m_isPerspective ? 1.0F / depth : -depth;
    }
    [[nodiscard]] float depthOf(float nearness) const
    {
        return m_isPerspective ? 1.0F / nearness : -nearness;
    }
    /// Screen rectangle of the box that stands for small shapes, and its nearness.
    [[nodiscard]] Extent smallBox(const ShownIndividual& shown) const;
    [[nodiscard]] const View& view() const { return m_view; }

private:
    struct Point
    {
        float x, y, nearness;
        bool isInFront;
    };
    [[nodiscard]] Point toScreen(const glm::vec3& eye) const;
    void transformVertices(const ShownIndividual& shown, int level);
    template<class Pixel>
    static bool fill(const Point& a, const Point& b, const Point& c, const PixelRect& rect,
                     Pixel& pixel);

    View m_view;
    bool m_isPerspective;
    float m_scale; ///< pixels a metre at depth 1, or at all depths
    std::vector<Point> m_points;
};

template<class Pixel>
void ShapeRaster::walk(const ShownIndividual& shown, const PixelRect& rect, Pixel&& pixel)
{
    const int meshLevel = level(shown);
    if (meshLevel < 0) {
        const Extent box = smallBox(shown);
        const PixelRect in = box.rect.clipped(rect);
        for (int y = in.y0; y < in.y1; ++y) {
            for (int x = in.x0; x < in.x1; ++x) {
                if (!pixel(x, y, box.nearness)) {
                    return;
                }
            }
        }
        return;
    }
    transformVertices(shown, meshLevel);
    const Mesh& mesh = shown.clip->asset->levels[static_cast<std::size_t>(meshLevel)];
    for (const Submesh& submesh : mesh.submeshes) {
        if (submesh.part >= 0 && (shown.parts >> static_cast<unsigned>(submesh.part) & 1U) == 0) {
            continue;
        }
        const std::uint32_t end = submesh.firstIndex + submesh.indexCount;
        for (std::uint32_t i = submesh.firstIndex; i + 2 < end; i += 3) {
            if (!fill(m_points[mesh.indices[i]], m_points[mesh.indices[i + 1]],
                      m_points[mesh.indices[i + 2]], rect, pixel)) {
                return;
            }
        }
    }
}

template<class Pixel>
bool ShapeRaster::fill(const Point& a, const Point& b, const Point& c, const PixelRect& rect,
                       Pixel& pixel)
{
    if (!a.isInFront || !b.isInFront || !c.isInFront) {
        return true;
    }
    // Clamped before they become whole numbers: far off screen they would not fit.
    const auto whole = [](float value, int low, int high) {
        return static_cast<int>(
            std::clamp(value, static_cast<float>(low), static_cast<float>(high)));
    };
    const int x0 = whole(std::ceil(std::min({a.x, b.x, c.x}) - 0.5F), rect.x0, rect.x1);
    const int x1 = whole(std::floor(std::max({a.x, b.x, c.x}) + 0.5F), rect.x0, rect.x1);
    const int y0 = whole(std::ceil(std::min({a.y, b.y, c.y}) - 0.5F), rect.y0, rect.y1);
    const int y1 = whole(std::floor(std::max({a.y, b.y, c.y}) + 0.5F), rect.y0, rect.y1);
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (x0 >= x1 || y0 >= y1 || area == 0.0F) {
        return true;
    }
    const float inverse = 1.0F / area;
    for (int y = y0; y < y1; ++y) {
        const float py = static_cast<float>(y) + 0.5F;
        for (int x = x0; x < x1; ++x) {
            const float px = static_cast<float>(x) + 0.5F;
            const float u = ((c.x - b.x) * (py - b.y) - (c.y - b.y) * (px - b.x)) * inverse;
            const float v = ((a.x - c.x) * (py - c.y) - (a.y - c.y) * (px - c.x)) * inverse;
            const float w = 1.0F - u - v;
            if (u >= 0.0F && v >= 0.0F && w >= 0.0F &&
                !pixel(x, y, u * a.nearness + v * b.nearness + w * c.nearness)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace crowd::model
