// SPDX-License-Identifier: MIT
#include "render/passes/BeamPass.h"

#include <algorithm>
#include <cmath>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>

#include "render/gl/Blending.h"

namespace crowd::render {

namespace {

constexpr int kBeamSides = 96;
constexpr float kBeyond = 1.5F;      ///< a beam ends so much farther off than what it is turned to
constexpr float kNarrow = 0.6F;      ///< radians of a cone that is seen as a beam
constexpr float kWide = 1.5F;        ///< and of one that is a flood: it is not seen in the air
constexpr float kAirLight = 0.0022F; ///< share of the light a metre away that a beam of 1 scatters

bool hasBeam(const PlacedLight& light)
{
    return light.beam > 0.0F && light.coneRadians > 0.0F && light.coneRadians < kWide &&
           light.reach > 0.01F;
}

void setCone(ShaderProgram& program, const PlacedLight& light)
{
    const glm::vec3 helper =
        std::abs(light.axis.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(1.0F, 0.0F, 0.0F);
    program.set("lamp", light.position);
    program.set("axis", light.axis);
    program.set("side", glm::normalize(glm::cross(light.axis, helper)));
    program.set("reach", light.reach * kBeyond);
    program.set("slope", std::tan(light.coneRadians * 0.5F));
    program.set("sides", kBeamSides);
    const float share = std::clamp((kWide - light.coneRadians) / (kWide - kNarrow), 0.0F, 1.0F);
    program.set("beamColor", light.color * (light.beam * share * kAirLight));
}

} // namespace

void BeamPass::initialize()
{
    m_nothing = GlVertexArray::create();
}

bool BeamPass::isNeeded(const PassContext& context)
{
    return std::ranges::any_of(context.style.lights, &hasBeam);
}

model::Result<void> BeamPass::draw(const PassContext& context)
{
    auto built = m_programs.get(context.style.tone.defines());
    if (!built) {
        return built.error();
    }
    ShaderProgram& program = *built.value();
    program.use();
    context.setCommon(program);
    program.set("eye", context.input.view.camera().position);
    glBindVertexArray(m_nothing.name());
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    blendAdding();
    glDepthMask(GL_FALSE);
    for (const PlacedLight& light : context.style.lights) {
        if (hasBeam(light)) {
            setCone(program, light);
            constexpr int kCorners = 2 * (kBeamSides + 1);
            glDrawArrays(GL_TRIANGLE_STRIP, 0, kCorners);
            context.countDraw(kCorners - 2);
        }
    }
    glDepthMask(GL_TRUE);
    blendOver(context.input.isTransparent);
    glDisable(GL_BLEND);
    return {};
}

} // namespace crowd::render
