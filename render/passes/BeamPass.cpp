// SPDX-License-Identifier: MIT
#include "render/passes/BeamPass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <glm/common.hpp>
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

/// The same noise in all parts of a picture.
glm::vec2 noiseCornerOf(const PassContext& context)
{
    const model::View& view = context.input.view;
    const glm::vec2 ratio = glm::vec2(context.pixelSize) / view.size();
    const float below = view.whole().size().y - view.corner().y - view.size().y;
    return glm::round(glm::vec2(view.corner().x, below) * ratio);
}

void setView(ShaderProgram& program, const PassContext& context, const DepthCopy* depths)
{
    const model::View& view = context.input.view;
    program.set("eye", view.camera().position);
    program.set("forward", view.camera().forward());
    program.set("isPerspective",
                view.camera().projection == model::Projection::Perspective ? 1 : 0);
    if (depths != nullptr) {
        program.set("unproject", unprojectOf(view));
        program.set("depths", 0);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, depths->texture().name());
    }
}

void setCut(ShaderProgram& program, const PassContext& context, std::size_t light)
{
    constexpr float kGoldenShare = 0.618034F;
    program.set("corner", noiseCornerOf(context));
    program.set("turn", kGoldenShare * static_cast<float>(context.input.ripeness.value_or(0)));
    program.set("lightShadowMap", kLightShadowUnit);
    program.set("lightMap", context.lightShadows.mapsFromWorld[light]);
}

/// What stands in its light is known.
bool isCut(const PassContext& context, std::size_t light)
{
    return context.style.lights[light].castsShadows && !context.lightShadows.mapsFromWorld.empty();
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

/// `index`: of the light.
model::Result<void> BeamPass::drawOne(const PassContext& context, std::size_t index,
                                      const DepthCopy* depths)
{
    const bool isQuick = context.isSoftware && context.input.samples == 0;
    std::string defines = isQuick ? "PLACES=8 " : "PLACES=16 ";
    defines += depths != nullptr ? "CLIPPED " : "";
    defines += isCut(context, index) ? "CUT " : "";
    auto built = m_programs.get(defines + context.style.tone.defines());
    if (!built) {
        return built.error();
    }
    ShaderProgram& program = *built.value();
    program.use();
    context.setCommon(program);
    setView(program, context, depths);
    setCone(program, context.style.lights[index]);
    if (isCut(context, index)) {
        setCut(program, context, index);
    }
    constexpr int kCorners = 2 * (kBeamSides + 1);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, kCorners);
    context.countDraw(kCorners - 2);
    return {};
}

model::Result<void> BeamPass::draw(const PassContext& context, const DepthCopy* depths)
{
    glBindVertexArray(m_nothing.name());
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    blendAdding();
    glDepthMask(GL_FALSE);
    (depths != nullptr ? glDisable : glEnable)(GL_DEPTH_TEST);
    const std::vector<PlacedLight>& lights = context.style.lights;
    model::Result<void> drawn;
    for (std::size_t i = 0; i < lights.size() && drawn; ++i) {
        if (hasBeam(lights[i])) {
            drawn = drawOne(context, i, depths);
        }
    }
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    blendOver(context.input.isTransparent);
    glDisable(GL_BLEND);
    return drawn;
}

} // namespace crowd::render
