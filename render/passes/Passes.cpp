// SPDX-License-Identifier: MIT
#include "render/passes/Passes.h"

#include <chrono>
#include <cstdint>
#include <utility>

#include <epoxy/gl.h>

namespace crowd::render {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// What the stencil says of the pixels that a pass draws, for areas that are drawn later.
enum class Mark : std::uint8_t { None, People, Others };

/// One step of a picture.
struct PassInfo
{
    const char* name;
    model::Result<void> (*draw)(Passes&, const PassContext&);
    Mark mark = Mark::None;
    bool (*isNeeded)(const PassContext&) = nullptr; ///< null: always
    bool isMesh = false;                            ///< of triangles whose edges a look may want
    bool isSolid = false; ///< hides what is behind it: has places and normals
};

bool hasPeople(const PassContext& context)
{
    return context.input.frame != nullptr;
}

/// In the order in which they are drawn. People first: they hide more of the stage than it hides of
/// them; what is seen through comes after what is not.
constexpr PassInfo kPasses[] = {
    {"people", [](Passes& p, const PassContext& c) { return p.people.draw(c, p.crowd, p.seen); },
     Mark::People, &hasPeople, true, true},
    {"depths of the stage", [](Passes& p, const PassContext& c) { return p.stage.drawDepths(c); },
     Mark::None, &StagePass::areDepthsWorthwhile},
    {"stage", [](Passes& p, const PassContext& c) { return p.stage.draw(c); }, Mark::Others,
     nullptr, true, true},
    {"ground", [](Passes& p, const PassContext& c) { return p.background.drawGround(c); },
     Mark::Others, [](const PassContext& c) { return c.style.hasGround; }, false, true},
    {"occlusion",
     [](Passes& p, const PassContext& c) {
         return p.depths.take(p.target) ? p.occlusion.draw(c, p.depths, p.target)
                                        : model::Result<void>();
     },
     Mark::None, [](const PassContext& c) { return c.style.occlusion > 0.0F; }},
    {"sky", [](Passes& p, const PassContext& c) { return p.background.drawSky(c); }, Mark::None,
     [](const PassContext& c) { return c.style.hasSky; }},
    {"ink",
     [](Passes& p, const PassContext& c) {
         return p.depths.take(p.target) ? p.ink.draw(c, p.depths) : model::Result<void>();
     },
     Mark::None, [](const PassContext& c) { return c.style.inkPixels > 0.0F; }},
    {"shadows",
     [](Passes& p, const PassContext& c) {
         p.blobs.draw(c, p.crowd.rows(), p.seen);
         return model::Result<void>();
     },
     Mark::None, [](const PassContext& c) { return hasPeople(c) && c.style.blobStrength > 0.0F; }},
    {"see-through stage", [](Passes& p, const PassContext& c) { return p.stage.drawBlended(c); },
     Mark::None, nullptr, true},
    {"see-through people",
     [](Passes& p, const PassContext& c) { return p.people.drawSeeThrough(c, p.crowd, p.seen); },
     Mark::None, &hasPeople, true},
    {"beams",
     [](Passes& p, const PassContext& c) {
         const bool areKnown = p.depths.take(p.target);
         return p.beams.draw(c, areKnown ? &p.depths : nullptr);
     },
     Mark::None, &BeamPass::isNeeded},
    {"overlay",
     [](Passes& p, const PassContext& c) {
         p.overlay.draw(c);
         return model::Result<void>();
     }},
    {"ghosts", [](Passes& p, const PassContext& c) { return p.ghosts.draw(c, p.crowd); }}};

/// Nothing to do where no areas are drawn.
void setMark(const RenderInput& input, Mark mark)
{
    if (mark == Mark::None || (input.areas.empty() && input.groundAreas.empty())) {
        glDisable(GL_STENCIL_TEST);
        return;
    }
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, mark == Mark::People ? kPeopleStencil : 0, 0xFFU);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void clear(const PassContext& context)
{
    const glm::vec4 color(context.style.clearColor, 1.0F);
    const glm::vec4 used = context.input.isTransparent ? glm::vec4(0.0F) : color;
    glClearColor(used.x, used.y, used.z, used.w);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

/// Where nothing is, it is as far as can be.
void moveSky(const RenderInput& input, AovPicture& picture)
{
    constexpr float kFar = 1e5F; // metres
    const model::View before(input.earlier->camera, glm::vec2(picture.size));
    const model::View now(input.view.camera(), glm::vec2(picture.size));
    if (now.camera().projection != model::Projection::Perspective) {
        return;
    }
    for (std::size_t i = 0; i < picture.rows.size(); ++i) {
        if (picture.rows[i] == AovPicture::kNothing) {
            const auto width = static_cast<std::size_t>(picture.size.x);
            const std::size_t line = i / width;
            const glm::vec2 pixel(static_cast<float>(i % width) + 0.5F,
                                  static_cast<float>(line) + 0.5F);
            const glm::vec3 there =
                before.camera().position + now.rayThrough(pixel).direction * kFar;
            const std::optional<glm::vec3> seen = before.project(there);
            picture.before[i] =
                seen ? glm::vec2(seen->x - pixel.x, pixel.y - seen->y) : glm::vec2(0.0F);
        }
    }
}

} // namespace

model::Result<void> Passes::initialize()
{
    crowd.initialize();
    seen.initialize();
    ghosts.initialize();
    shadows.initialize();
    lightShadows.initialize();
    background.initialize();
    beams.initialize();
    occlusion.initialize();
    edges.initialize();
    ink.initialize();
    auto ready = blobs.initialize();
    ready = ready ? overlay.initialize() : ready;
    return ready ? outline.initialize() : ready;
}

void Passes::prepare(const PassContext& context)
{
    const RenderInput& input = context.input;
    RenderStatistics& statistics = context.statistics;
    auto start = Clock::now();
    crowd.update(input);
    if (!input.frame) {
        return;
    }
    statistics.recordsMs = millisecondsSince(start);
    start = Clock::now();
    const float ratio = static_cast<float>(context.pixelSize.y) / input.view.size().y;
    LevelThresholds levels = input.levels;
    levels.impostorPixels = context.style.hasCards ? levels.impostorPixels : 0.0F;
    seen.plan({*input.frame, input.view, ratio, levels, input.selected, input.hovered}, crowd);
    crowd.want(seen.planned().wantedImpostors(), input.keyframes);
    statistics.planMs = millisecondsSince(start);
    crowd.upload(statistics);
    seen.upload(input.view.camera(), crowd);
    statistics.individuals = static_cast<int>(input.frame->population.size());
    statistics.visible = static_cast<int>(seen.planned().instances().size());
    statistics.byLevel = seen.planned().byLevel();
    statistics.areKeyframesMissing = seen.planned().areKeyframesMissing();
}

model::Result<void> Passes::drawShadows(PassContext& context)
{
    const bool isSunNeeded = context.style.castsShadows();
    const bool areLightsNeeded = LightShadowPass::isNeeded(context);
    model::Result<void> drawn;
    if (isSunNeeded) {
        drawn = shadows.draw(context, crowd);
    } else {
        shadows.rest();
    }
    if (areLightsNeeded && drawn) {
        drawn = lightShadows.draw(context, crowd);
    } else {
        lightShadows.rest();
    }
    if (isSunNeeded || areLightsNeeded) {
        target.bind();
    }
    return drawn;
}

model::Result<void> Passes::draw(PassContext context)
{
    prepare(context);
    if (auto drawn = drawShadows(context); !drawn) {
        return drawn;
    }
    clear(context);
    for (const PassInfo& pass : kPasses) {
        if (pass.isNeeded != nullptr && !pass.isNeeded(context)) {
            continue;
        }
        setMark(context.input, pass.mark);
        const bool isWire = context.style.isWire && pass.isMesh;
        glPolygonMode(GL_FRONT_AND_BACK, isWire ? GL_LINE : GL_FILL);
        auto drawn = pass.draw(*this, context);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        if (!drawn) {
            return model::Error{QT_TRANSLATE_NOOP("Messages", "Drawing the %1 failed. %2"),
                                pass.name, drawn.error().said};
        }
    }
    return {};
}

model::Result<AovPicture> Passes::drawAovs(PassContext context)
{
    prepare(context);
    if (context.input.earlier) {
        context.earlier = &earlier;
        if (context.input.frame) {
            earlier.update(context.input, crowd);
        }
    }
    auto drawn = aovs.begin(context.pixelSize, context.earlier != nullptr);
    for (const PassInfo& pass : kPasses) {
        if (drawn && pass.isSolid && (pass.isNeeded == nullptr || pass.isNeeded(context))) {
            drawn = pass.draw(*this, context);
        }
    }
    if (!drawn) {
        aovs = {};
        return drawn.error();
    }
    AovPicture picture = aovs.take();
    if (context.input.earlier) {
        moveSky(context.input, picture);
    }
    return picture;
}

model::Result<void> Passes::finish(const PassContext& context, const std::uint32_t* framebuffer)
{
    const RenderInput& input = context.input;
    const bool isHighlighted =
        input.frame && !input.isDeep && !seen.planned().highlighted().empty();
    const bool isSmoothed = EdgePass::isNeeded(context);
    model::Result<void> drawn;
    target.resolve();
    if (input.ripeness) {
        drawn = sum.add(*input.ripeness, target.resolved(), target.resolvedFrame(), target.size());
    }
    const glm::ivec2 shown = input.framebufferSize;
    const bool isScaled = framebuffer != nullptr && shown.x > 0 && shown != target.size();
    target.end(isScaled ? nullptr : framebuffer, isHighlighted || isSmoothed);
    if (isSmoothed && drawn) {
        drawn = edges.draw(context, target.resolved());
    }
    if (isHighlighted) {
        outline.draw(context, target.resolved(), crowd, seen.planned());
    }
    if (isScaled) {
        target.scaleTo(*framebuffer, shown);
    }
    return drawn;
}

} // namespace crowd::render
