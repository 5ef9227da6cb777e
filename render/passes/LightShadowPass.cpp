// SPDX-License-Identifier: MIT
#include "render/passes/LightShadowPass.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

#include <epoxy/gl.h>
#include <glm/gtc/matrix_transform.hpp>

#include "render/passes/CasterDrawing.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr int kFewestPartPixels = 256;
constexpr int kMostPartPixels = 2048;
constexpr int kMostMapPixels = 4096; ///< of all parts beside each other
constexpr float kLampOffsetTexels = 1.5F;
constexpr float kSpreadTexels = 1.2F;

/// Parts beside each other, and above each other.
int partsAcross(std::size_t views)
{
    std::size_t across = 1;
    while (across * across < views) {
        ++across;
    }
    return static_cast<int>(across);
}

/// Half of what the picture has, in steps: a cone fills a part of the picture.
int partPixels(glm::ivec2 picture, int across)
{
    constexpr int kStep = 128;
    const int wanted = std::max(picture.x, picture.y) / 2;
    const int pixels =
        std::clamp((wanted + kStep - 1) / kStep * kStep, kFewestPartPixels, kMostPartPixels);
    return std::min(pixels, kMostMapPixels / across);
}

/// 0..1 within a part of the map, and 0..1 of depth.
glm::mat4 mapFromClip(std::size_t view, int across)
{
    const float share = 1.0F / static_cast<float>(across);
    const auto index = static_cast<int>(view);
    const int column = index % across;
    const int row = index / across;
    const glm::vec3 corner(static_cast<float>(column) * share, static_cast<float>(row) * share,
                           0.0F);
    const glm::vec3 half(0.5F * share, 0.5F * share, 0.5F);
    return glm::scale(glm::translate(glm::mat4(1.0F), corner + half), half);
}

} // namespace

void LightShadowPass::initialize()
{
    m_seen.initialize();
}

bool LightShadowPass::isNeeded(const PassContext& context)
{
    return context.style.casters.all > 0;
}

template<class Draw>
Result<void> LightShadowPass::forEachLamp(const Draw& draw) const
{
    const int across = partsAcross(m_lamps.size());
    for (std::size_t i = 0; i < m_lamps.size(); ++i) {
        const auto index = static_cast<int>(i);
        glViewport(index % across * m_pixels, index / across * m_pixels, m_pixels, m_pixels);
        if (auto drawn = draw(m_lamps[i]); !drawn) {
            return drawn;
        }
    }
    return {};
}

Result<void> LightShadowPass::drawPeople(const PassContext& casting, CrowdGpu& crowd,
                                         const LampView& lamp)
{
    return drawCasters(casting, m_people, crowd, m_seen, lamp.view);
}

/// Where the shaders find each on the map.
void LightShadowPass::tell(PassContext& context) const
{
    const int across = partsAcross(m_lamps.size());
    LightShadows& told = context.lightShadows;
    told = {};
    for (std::size_t i = 0; i < m_lamps.size(); ++i) {
        told.mapsFromWorld.push_back(mapFromClip(i, across) * m_lamps[i].clipFromWorld);
    }
    const LightCasters& casters = context.style.casters;
    std::size_t view = 0;
    for (std::size_t i = 0; i < casters.all; ++i) {
        told.offsets.push_back(m_lamps[view].texelSlope * kLampOffsetTexels);
        view += viewsOf(context.style.lights[i]);
    }
    told.spread = kSpreadTexels / static_cast<float>(m_pixels * across);
    context.style.surfaceDefines += "LIGHT_SHADOWS=" + std::to_string(casters.all) + ' ' +
                                    "SPOT_SHADOWS=" + std::to_string(casters.spots) + ' ';
    // Without anti-aliasing a hard edge is as good as its texels.
    const bool isQuick = context.isSoftware && context.input.samples == 0;
    context.style.surfaceDefines += isQuick ? "" : "LIGHT_TAPS4 ";
}

void LightShadowPass::look(const PassContext& context)
{
    const std::span<const PlacedLight> casting(context.style.lights.data(),
                                               context.style.casters.all);
    std::size_t views = 0;
    for (const PlacedLight& light : casting) {
        views += viewsOf(light);
    }
    m_pixels = partPixels(context.wholePixels(), partsAcross(views)) >> context.reduction;
    m_lamps.clear();
    for (const PlacedLight& light : casting) {
        for (std::size_t side = 0; side < viewsOf(light); ++side) {
            m_lamps.push_back(lampView(light, m_pixels, side));
        }
    }
}

Result<void> LightShadowPass::draw(PassContext& context, CrowdGpu& crowd)
{
    look(context);
    std::vector<glm::mat4> views(m_lamps.size());
    std::ranges::transform(m_lamps, views.begin(), &LampView::clipFromWorld);
    PassContext casting = context;
    casting.style.shadowStrength = 0.0F;
    casting.style.lights.clear();
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5F, 4.0F);
    const auto through = [&casting](const LampView& lamp) -> const PassContext& {
        casting.viewProjection = lamp.clipFromWorld;
        return casting;
    };
    const auto begun =
        m_still.begin(m_target, m_pixels * partsAcross(m_lamps.size()), context, views, [&] {
            return forEachLamp(
                [&](const LampView& lamp) { return m_stage.drawCasters(through(lamp)); });
        });
    Result<void> drawn = begun ? Result<void>() : begun.error();
    if (begun && begun.value() && context.input.frame) {
        drawn = forEachLamp(
            [&](const LampView& lamp) { return drawPeople(through(lamp), crowd, lamp); });
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    if (begun && begun.value()) {
        m_target.bindTexture(kLightShadowUnit);
        glActiveTexture(GL_TEXTURE0);
        tell(context);
    } else {
        context.style.casters = {};
    }
    return drawn;
}

} // namespace crowd::render
