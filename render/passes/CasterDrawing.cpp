// SPDX-License-Identifier: MIT
#include "render/passes/CasterDrawing.h"

namespace crowd::render {

namespace {

/// Texels of a shadow map in which people are as tall as the levels' thresholds want.
constexpr LevelThresholds kShadowLevels{{90.0F, 45.0F, 22.0F}, 0.0F};
/// Below that cards have more texels than the map.
constexpr float kCardTexels = 34.0F;

LevelThresholds levelsOf(const PassContext& context)
{
    LevelThresholds levels = kShadowLevels;
    const bool hasCards = context.style.hasCards && context.input.levels.impostorPixels > 0.0F;
    levels.impostorPixels = hasCards ? kCardTexels : 0.0F;
    return levels;
}

} // namespace

model::Result<void> drawCasters(const PassContext& context, PeopleDrawing& people, CrowdGpu& crowd,
                                CrowdView& seen, const model::View& light)
{
    seen.plan({*context.input.frame, light, 1.0F, levelsOf(context)}, crowd);
    seen.uploadSolid();
    crowd.want(seen.planned().wantedImpostors(), context.input.keyframes);
    const PeopleDrawing::CrowdDraw drawing{crowd.rows(), seen.instances(), "",
                                           1.0F,         Surface::Caster,  &light};
    for (const InstanceRun& run : seen.runs()) {
        if (auto drawn = people.draw(context, drawing, crowd.gpuOf(run.entry), run); !drawn) {
            return drawn;
        }
    }
    return {};
}

} // namespace crowd::render
