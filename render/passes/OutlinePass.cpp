// SPDX-License-Identifier: MIT
#include "render/passes/OutlinePass.h"

#include <algorithm>
#include <cmath>

#include <epoxy/gl.h>

namespace crowd::render {

namespace {

constexpr float kReach = 2.0F; ///< logical pixels
constexpr glm::vec3 kHoverColor{1.0F, 1.0F, 1.0F};

} // namespace

model::Result<void> OutlinePass::initialize()
{
    auto program = ShaderProgram::build("outline");
    if (!program) {
        return program.error();
    }
    m_program = std::move(program).value();
    m_nothing = GlVertexArray::create();
    return {};
}

void OutlinePass::draw(const PassContext& context, std::uint32_t picture, const PixelRect& part)
{
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (part.isEmpty()) {
        return;
    }
    const float ratio =
        static_cast<float>(context.pixelSize.y) / std::max(1.0F, context.input.view.size().y);
    m_program.use();
    m_program.set("picture", 0);
    m_program.set("reach", std::max(1.0F, std::round(kReach * ratio)));
    m_program.set("selectionColor", context.input.selectionColor);
    m_program.set("hoverColor", kHoverColor);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture);
    glBindVertexArray(m_nothing.name());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.low.x, part.low.y, part.high.x - part.low.x, part.high.y - part.low.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glBindTexture(GL_TEXTURE_2D, 0);
    context.countDraw(1);
}

} // namespace crowd::render
