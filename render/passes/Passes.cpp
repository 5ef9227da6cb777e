// SPDX-License-Identifier: MIT
#include "render/passes/Passes.h"

#include <cstdint>

#include <epoxy/gl.h>

#include "model/base/Color.h"

namespace crowd::render {

namespace {

/// What the stencil says of the pixels that a pass draws, for areas that are drawn later.
enum class Mark : std::uint8_t { None, People, Others };

/// One step of a picture.
struct PassInfo
{
    const char* name;
    model::Result<void> (*draw)(Passes&, const PassContext&);
    Mark mark = Mark::None;
    bool (*isNeeded)(const RenderInput&) = nullptr; ///< null: always
};

bool hasSky(const RenderInput& input)
{
    return input.background.w <= 0.0F && !input.isTransparent;
}

/// In the order in which they are drawn. People first: they hide more of the stage than it hides of
/// them; what is seen through comes after what is not.
constexpr PassInfo kPasses[] = {
    {"people", [](Passes& p, const PassContext& c) { return p.crowd.drawPeople(c); }, Mark::People},
    {"stage", [](Passes& p, const PassContext& c) { return p.stage.draw(c); }, Mark::Others},
    {"ground",
     [](Passes& p, const PassContext& c) {
         p.background.drawGround(c);
         return model::Result<void>();
     },
     Mark::Others,
     [](const RenderInput& input) { return input.showGround && !input.isTransparent; }},
    {"sky",
     [](Passes& p, const PassContext& c) {
         p.background.drawSky(c);
         return model::Result<void>();
     },
     Mark::None, &hasSky},
    {"shadows",
     [](Passes& p, const PassContext& c) {
         p.crowd.drawShadows(c);
         return model::Result<void>();
     }},
    {"see-through stage", [](Passes& p, const PassContext& c) { return p.stage.drawBlended(c); }},
    {"see-through people",
     [](Passes& p, const PassContext& c) { return p.crowd.drawSeeThrough(c); }},
    {"overlay",
     [](Passes& p, const PassContext& c) {
         p.overlay.draw(c);
         return model::Result<void>();
     }},
    {"ghosts", [](Passes& p, const PassContext& c) { return p.crowd.drawGhosts(c); }}};

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
    if (context.input.isTransparent) {
        glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    } else {
        const glm::vec3 color = hasSky(context.input)
                                    ? context.light.horizon
                                    : model::linearFromSrgb(glm::vec3(context.input.background));
        glClearColor(color.x, color.y, color.z, 1.0F);
    }
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

} // namespace

model::Result<void> Passes::initialize()
{
    auto ready = crowd.initialize();
    ready = ready ? background.initialize() : ready;
    ready = ready ? overlay.initialize() : ready;
    return ready ? outline.initialize() : ready;
}

model::Result<void> Passes::draw(const PassContext& context)
{
    clear(context);
    for (const PassInfo& pass : kPasses) {
        if (pass.isNeeded != nullptr && !pass.isNeeded(context.input)) {
            continue;
        }
        setMark(context.input, pass.mark);
        if (auto drawn = pass.draw(*this, context); !drawn) {
            return model::Error{QT_TRANSLATE_NOOP("Messages", "Drawing the %1 failed. %2"),
                                pass.name, drawn.error().said};
        }
    }
    return {};
}

} // namespace crowd::render
