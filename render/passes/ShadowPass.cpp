// SPDX-License-Identifier: MIT
#include "render/passes/ShadowPass.h"

#include <algorithm>
#include <cmath>

#include <epoxy/gl.h>

#include "model/base/Bounds.h"
#include "render/passes/CasterDrawing.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr int kFewestPixels = 512;
constexpr int kMostPixels = 4096;
/// Nobody of this size looks at a shadow.
constexpr float kLeastPixelsPerMetre = 8.0F;
/// How far shadows of people reach beyond them.
constexpr float kShadowMetres = 6.0F;
/// Metres from the ground: who is higher receives no shadows, nor who has left, far below.
constexpr float kHighest = 300.0F;
/// Soft edges are as wide as if what casts them were so far away.
constexpr float kCasterMetres = 2.0F;
constexpr float kOffsetTexels = 1.5F;
/// From here on soft edges take more taps.
constexpr float kSoftTexels = 1.5F;

Bounds boundsOf(const PassContext& context)
{
    Bounds bounds;
    for (const StageEntry& entry : context.input.stages) {
        if (entry.asset && !entry.asset->bounds.isEmpty()) {
            const glm::mat4 matrix = entry.worldFromStage();
            for (unsigned corner = 0; corner < 8; ++corner) {
                const glm::vec3 point = cornerOf(entry.asset->bounds, corner);
                bounds.addPlace(glm::vec3(matrix * glm::vec4(point, 1.0F)));
            }
        }
    }
    return bounds;
}

Bounds boundsOfPeople(const PassContext& context)
{
    Bounds bounds;
    if (context.input.frame) {
        for (const glm::vec3& place : context.input.frame->population.column(columns::position)) {
            if (std::abs(place.y) < kHighest) {
                bounds.addPlace(place);
            }
        }
    }
    if (!bounds.isEmpty()) {
        bounds.low -= glm::vec3(kShadowMetres, 1.0F, kShadowMetres);
        bounds.high += glm::vec3(kShadowMetres, 3.0F, kShadowMetres);
    }
    return bounds;
}

/// A little more than the picture has, in steps: windows are resized by single pixels.
int mapPixels(const PassContext& context)
{
    const glm::ivec2 picture = context.wholePixels();
    constexpr int kStep = 256;
    const int longest = std::max(picture.x, picture.y);
    const int wanted = longest + longest / 5;
    return std::clamp((wanted + kStep - 1) / kStep * kStep, kFewestPixels, kMostPixels) >>
           context.reduction;
}

} // namespace

void ShadowPass::initialize()
{
    m_seen.initialize();
}

std::optional<SunView> ShadowPass::sunView(const PassContext& context) const
{
    const View view = context.input.view.whole(); // all parts of a picture are in the same shadows
    const Bounds people = boundsOfPeople(context);
    Bounds all = boundsOf(context);
    all.add(people);
    if (all.isEmpty()) {
        return std::nullopt;
    }
    // As far as a metre is some pixels high, and so far behind the nearest of them.
    const Bounds& subject = people.isEmpty() ? all : people;
    const glm::vec3 eye = view.camera().position;
    const float away = glm::length(glm::max(glm::max(subject.low - eye, eye - subject.high), 0.0F));
    const float reach = view.pixelsPerMetre(1.0F) / kLeastPixelsPerMetre;
    return fitSunView(view, away + reach, all, context.style.light.sunDirection,
                      mapPixels(context));
}

void ShadowPass::tell(PassContext& context, const SunView& sun) const
{
    m_target.bindTexture(kShadowUnit);
    glActiveTexture(GL_TEXTURE0);
    const float metres = std::tan(context.style.shadowSoftness * 0.5F) * kCasterMetres;
    const float texels = std::max(metres / sun.texelMetres, 0.5F);
    context.shadows = {sun.mapFromWorld, texels * sun.texelMetres / sun.metres,
                       sun.texelMetres * kOffsetTexels};
    // Without anti-aliasing a hard edge is as good as its texels.
    const bool isQuick = context.isSoftware && context.input.samples == 0;
    const bool isSoft = texels > kSoftTexels;
    context.style.surfaceDefines += isQuick && !isSoft  ? "SHADOWED "
                                    : isQuick == isSoft ? "SHADOWED TAPS4 "
                                                        : "SHADOWED TAPS8 ";
}

Result<void> ShadowPass::draw(PassContext& context, CrowdGpu& crowd)
{
    const auto sun = sunView(context);
    if (!sun) {
        context.style.shadowStrength = 0.0F;
        return {};
    }
    PassContext casting = context;
    casting.viewProjection = sun->clipFromWorld;
    casting.style.shadowStrength = 0.0F;
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5F, 4.0F);
    const auto begun =
        m_still.begin(m_target, mapPixels(context), casting, {&sun->clipFromWorld, 1},
                      [&] { return m_stage.drawCasters(casting); });
    Result<void> drawn = begun ? Result<void>() : begun.error();
    if (begun && begun.value() && context.input.frame) {
        drawn = drawCasters(casting, m_people, crowd, m_seen, sun->view);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    if (begun && begun.value()) {
        tell(context, *sun);
    } else {
        context.style.shadowStrength = 0.0F;
    }
    return drawn;
}

} // namespace crowd::render
