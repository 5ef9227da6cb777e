// SPDX-License-Identifier: MIT
#include "model/pick/ShapeRaster.h"

#include <array>

namespace crowd::model {

namespace {

/// Projected heights below which the next coarser level gives the shape, as the picture does.
constexpr std::array<float, kMaxLevels - 1> kLevelPixels{60.0F, 35.0F, 18.0F};
constexpr float kBoxPixels = 8.0F;

const Bounds& keyframeBox(const ShownIndividual& shown)
{
    const auto& boxes = shown.clip->baked->keyframeBounds;
    const auto keyframe = static_cast<std::size_t>(shown.keyframe);
    return keyframe < boxes.size() ? boxes[keyframe] : shown.clip->baked->bounds;
}

int roundedDown(float value)
{
    return static_cast<int>(std::floor(std::clamp(value, -1.0e6F, 1.0e6F)));
}

} // namespace

ShapeRaster::ShapeRaster(const View& view)
    : m_view(view), m_isPerspective(view.camera().projection == Projection::Perspective),
      m_scale(view.pixelsPerMetre(1.0F))
{
}

ShapeRaster::Point ShapeRaster::toScreen(const glm::vec3& eye) const
{
    const float depth = -eye.z;
    if (depth < m_view.nearPlane()) {
        return {0.0F, 0.0F, 0.0F, false};
    }
    const float scale = m_isPerspective ? m_scale / depth : m_scale;
    return {m_view.size().x * 0.5F + eye.x * scale, m_view.size().y * 0.5F - eye.y * scale,
            nearnessOf(depth), true};
}

float ShapeRaster::heightPixels(const ShownIndividual& shown) const
{
    const Bounds& box = keyframeBox(shown);
    const glm::vec3 eye(m_view.viewMatrix() * glm::vec4(shown.position, 1.0F));
    const float depth = std::max(-eye.z, 0.1F);
    return box.size().y * shown.height * (m_isPerspective ? m_scale / depth : m_scale);
}

int ShapeRaster::level(const ShownIndividual& shown) const
{
    const float pixels = heightPixels(shown);
    if (pixels < kBoxPixels) {
        return -1;
    }
    int wanted = 0;
    for (const float threshold : kLevelPixels) {
        wanted += pixels < threshold ? 1 : 0;
    }
    const std::size_t levels =
        std::min(shown.clip->baked->levels.size(), shown.clip->asset->levels.size());
    return std::min(wanted, static_cast<int>(levels) - 1);
}

void ShapeRaster::transformVertices(const ShownIndividual& shown, int level)
{
    const glm::mat4 eyeFromTemplate = m_view.viewMatrix() * shown.worldFromTemplate();
    const BakedClip& baked = *shown.clip->baked;
    const std::size_t count =
        shown.clip->asset->levels[static_cast<std::size_t>(level)].positions.size();
    m_points.resize(count);
    for (std::size_t v = 0; v < count; ++v) {
        const glm::vec3 local = baked.position(level, shown.keyframe, v);
        m_points[v] = toScreen(glm::vec3(eyeFromTemplate * glm::vec4(local, 1.0F)));
    }
}

std::optional<ShapeRaster::Extent> ShapeRaster::extent(const ShownIndividual& shown) const
{
    const glm::mat4 eyeFromTemplate = m_view.viewMatrix() * shown.worldFromTemplate();
    const Bounds& box = keyframeBox(shown);
    glm::vec2 low(1.0e30F);
    glm::vec2 high(-1.0e30F);
    float nearness = -1.0e30F;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 local((corner & 1) != 0 ? box.high.x : box.low.x,
                              (corner & 2) != 0 ? box.high.y : box.low.y,
                              (corner & 4) != 0 ? box.high.z : box.low.z, 1.0F);
        const Point at = toScreen(glm::vec3(eyeFromTemplate * local));
        if (!at.isInFront) {
            return std::nullopt;
        }
        low = glm::min(low, glm::vec2(at.x, at.y));
        high = glm::max(high, glm::vec2(at.x, at.y));
        nearness = std::max(nearness, at.nearness);
    }
    return Extent{
        {roundedDown(low.x), roundedDown(low.y), roundedDown(high.x) + 1, roundedDown(high.y) + 1},
        nearness};
}

ShapeRaster::Extent ShapeRaster::smallBox(const ShownIndividual& shown) const
{
    const Bounds& box = keyframeBox(shown);
    const float middle = 0.5F * (box.low.y + box.high.y) * shown.height;
    const glm::vec3 center = shown.position + glm::vec3(0.0F, middle, 0.0F);
    const Point at = toScreen(glm::vec3(m_view.viewMatrix() * glm::vec4(center, 1.0F)));
    if (!at.isInFront) {
        return {};
    }
    const float scale = m_isPerspective ? m_scale * at.nearness : m_scale;
    const glm::vec2 half(0.25F * (box.size().x + box.size().z) * shown.girth * scale,
                         0.5F * box.size().y * shown.height * scale);
    // Never less than the pixel that the centre falls on.
    const int x = roundedDown(at.x);
    const int y = roundedDown(at.y);
    return {{std::min(x, roundedDown(at.x - half.x + 0.5F)),
             std::min(y, roundedDown(at.y - half.y + 0.5F)),
             std::max(x + 1, roundedDown(at.x + half.x + 0.5F)),
             std::max(y + 1, roundedDown(at.y + half.y + 0.5F))},
            at.nearness};
}

} // namespace crowd::model
