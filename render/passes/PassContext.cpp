// SPDX-License-Identifier: MIT
#include "render/passes/PassContext.h"

#include <vector>

#include "model/view/View.h"
#include "render/gl/ShaderProgram.h"

namespace crowd::render {

void PassContext::setCommon(ShaderProgram& program) const
{
    program.set("viewProjection", viewProjection);
    program.set("sunDirection", style.light.sunDirection);
    program.set("sunColor", style.light.sun);
    program.set("skyColor", style.light.sky);
    program.set("bounceColor", style.light.bounce);
    program.set("toneGain", style.tone.gain);
    program.set("fullLight", style.light.fullLuminance());
    if (style.tone.hazePerMetre > 0.0F) {
        program.set("eye", input.view.camera().position);
        program.set("hazePerMetre", style.tone.hazePerMetre);
        program.set("hazeHeight", style.tone.hazeHeight);
        program.set("hazeColor", style.light.horizon);
    }
    if (!style.lights.empty()) {
        setLights(program);
    }
    if (earlier != nullptr) {
        setEarlier(program);
    }
    if (style.highlights > 0.0F) {
        setHighlights(program);
    }
    if (style.castsShadows()) {
        program.set("shadowMap", kShadowUnit);
        program.set("mapFromWorld", shadows.mapFromWorld);
        program.set("shadowOffset", shadows.offset);
        program.set("shadowSpread", shadows.spread);
        program.set("shadowStrength", style.shadowStrength);
        program.set("shadowTint", style.shadowTint());
    }
}

void PassContext::setHighlights(ShaderProgram& program) const
{
    const model::Camera& camera = input.view.camera();
    const bool isParallel = camera.projection == model::Projection::Orthographic;
    program.set("viewer",
                isParallel ? glm::vec4(-camera.forward(), 0.0F) : glm::vec4(camera.position, 1.0F));
    program.set("highlights", style.highlights);
    program.set("mirroredZenith", style.light.zenith);
    program.set("mirroredHorizon", style.light.horizon);
    program.set("mirroredGround", style.groundColor);
}

void PassContext::setEarlier(ShaderProgram& program) const
{
    const model::View before(input.earlier->camera, input.view.size());
    program.set("earlierViewProjection", before.viewProjection());
    program.set("pictureSize", glm::vec2(pixelSize));
}

void PassContext::setLights(ShaderProgram& program) const
{
    std::vector<glm::vec4> places;
    std::vector<glm::vec4> axes;
    std::vector<float> squares;
    std::vector<glm::vec4> colors;
    const std::vector<float>& offsets = lightShadows.offsets;
    for (const PlacedLight& light : style.lights) {
        const std::size_t index = colors.size();
        places.emplace_back(light.position, light.edgeSlope);
        axes.emplace_back(light.axis, light.edgeCosine);
        squares.push_back(light.sizeMetres * light.sizeMetres);
        colors.emplace_back(light.color, index < offsets.size() ? offsets[index] : 0.0F);
    }
    program.set("lightPlaces[0]", places);
    program.set("lightAxes[0]", axes);
    program.set("lightSquares[0]", squares);
    program.set("lightColors[0]", colors);
    if (!lightShadows.mapsFromWorld.empty()) {
        program.set("lightShadowMap", kLightShadowUnit);
        program.set("lightMaps[0]", lightShadows.mapsFromWorld);
        program.set("lightShadowSpread", lightShadows.spread);
    }
}

glm::ivec2 PassContext::wholePixels() const
{
    const glm::vec2 share = input.view.whole().size() / input.view.size();
    return {glm::vec2(pixelSize) * share + 0.5F};
}

void PassContext::countDraw(std::int64_t triangles) const
{
    ++statistics.draws;
    statistics.triangles += triangles;
}

} // namespace crowd::render
