// SPDX-License-Identifier: MIT
#include "render/style/Style.h"

#include "model/base/Color.h"

namespace crowd::render {

Style Style::of(const RenderInput& input)
{
    const LookInfo& look = lookInfo(input.look);
    Style style;
    style.surfaceDefines = look.defines;
    style.light = LinearLight::from(input.lighting);
    style.hasSky = input.background.w <= 0.0F && !input.isTransparent;
    style.hasGround = input.showGround && !input.isTransparent;
    style.hasGrid = input.lighting.showGroundGrid;
    style.clearColor =
        style.hasSky ? style.light.horizon : model::linearFromSrgb(glm::vec3(input.background));
    style.groundColor =
        style.light.ground * (look.isLit ? style.light.onGround() : glm::vec3(1.0F));
    style.shadowStrength = input.showShadows ? style.shadowStrength : 0.0F;
    style.selectionColor = input.selectionColor;
    return style;
}

} // namespace crowd::render
