// SPDX-License-Identifier: MIT
#include "render/passes/EdgePass.h"

#include <epoxy/gl.h>

namespace crowd::render {

namespace {

/// So many pictures of several hide the steps of edges by themselves.
constexpr int kRipe = 4;

/// Without it the picture could not be read as it is seen.
bool canReadEncoded()
{
    return epoxy_has_gl_extension("GL_EXT_texture_sRGB_decode");
}

/// Of the bound texture.
void setReading(GLint decode, GLint filter)
{
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, decode);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
}

} // namespace

void EdgePass::initialize()
{
    m_nothing = GlVertexArray::create();
}

bool EdgePass::isNeeded(const PassContext& context)
{
    const RenderInput& input = context.input;
    return input.smoothsEdges && input.samples == 0 && !input.isTransparent && !input.isDeep &&
           input.ripeness.value_or(0) < kRipe && canReadEncoded();
}

model::Result<void> EdgePass::drawOne(const PassContext& context, const char* defines)
{
    auto built = m_programs.get(defines);
    if (!built) {
        return built.error();
    }
    ShaderProgram& program = *built.value();
    program.use();
    program.set("picture", 0);
    program.set("texel", 1.0F / glm::vec2(context.pixelSize));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    context.countDraw(1);
    return {};
}

model::Result<void> EdgePass::draw(const PassContext& context, std::uint32_t picture)
{
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture);
    setReading(GL_SKIP_DECODE_EXT, GL_NEAREST);
    glBindVertexArray(m_nothing.name());
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    // Few pixels are on an edge: they are marked, so that the long way is gone for them alone.
    glClearStencil(0);
    glClearDepth(1.0);
    glClear(GL_STENCIL_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 0xFFU);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    auto drawn = drawOne(context, "MARKED");
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE); // alpha says who is highlighted
    glStencilFunc(GL_EQUAL, 1, 0xFFU);
    glStencilMask(0U);
    setReading(GL_SKIP_DECODE_EXT, GL_LINEAR);
    drawn = drawn ? drawOne(context, "") : drawn;
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilMask(0xFFU);
    glDisable(GL_STENCIL_TEST);
    setReading(GL_DECODE_EXT, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    return drawn;
}

} // namespace crowd::render
