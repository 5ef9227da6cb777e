// SPDX-License-Identifier: MIT
#include "render/SceneLook.h"

#include <cstddef>
#include <string_view>

#include "model/base/Color.h"

namespace crowd::render {

namespace {

constexpr bool isEveryStyleALook()
{
    for (std::size_t i = 0; i < kLooks.size(); ++i) {
        if (std::string_view(kLooks[i].key) != model::kLookStyles[i].key) {
            return false;
        }
    }
    return kLooks.size() == model::kLookStyles.size();
}
static_assert(isEveryStyleALook());

glm::vec3 srgbOf(const model::PaintColor& color)
{
    return glm::vec3(color[0], color[1], color[2]) / 255.0F;
}

} // namespace

void useLook(RenderInput& input, const model::LookPreset& look)
{
    input.look = lookOf(look.style);
    input.lighting = model::lightIn(look, input.lighting);
    input.isTwoTone = look.isTwoTone;
    if (!look.hasLamps) {
        input.lights = {};
    }
    input.showShadows = input.showShadows && look.hasShadows;
    input.showGround = input.showGround && look.hasGround;
    if (look.hasBackground) {
        input.background = glm::vec4(srgbOf(look.background), 1.0F);
    }
    if (look.hasOutline) {
        input.ink = InkLine{look.outlinePixels, srgbOf(look.outline)};
    }
}

} // namespace crowd::render
