// SPDX-License-Identifier: MIT
#include "render/passes/PassContext.h"

#include "render/gl/ShaderProgram.h"

namespace crowd::render {

void PassContext::setCommon(ShaderProgram& program) const
{
    program.set("viewProjection", viewProjection);
    program.set("sunDirection", style.light.sunDirection);
    program.set("sunColor", style.light.sun);
    program.set("skyColor", style.light.sky);
    program.set("bounceColor", style.light.bounce);
    if (style.castsShadows()) {
        program.set("shadowMap", kShadowUnit);
        program.set("mapFromWorld", shadows.mapFromWorld);
        program.set("shadowOffset", shadows.offset);
        program.set("shadowSpread", shadows.spread);
        program.set("shadowStrength", style.shadowStrength);
        program.set("shadowTint", style.shadowTint());
    }
}

void PassContext::countDraw(std::int64_t triangles) const
{
    ++statistics.draws;
    statistics.triangles += triangles;
}

} // namespace crowd::render
