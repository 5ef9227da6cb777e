// SPDX-License-Identifier: MIT
#include "render/passes/BlobPass.h"

#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <epoxy/gl.h>

#include "render/passes/PeopleDrawing.h"

namespace crowd::render {

namespace {

constexpr int kBlobCorners = 8;

} // namespace

model::Result<void> BlobPass::initialize()
{
    auto blob = ShaderProgram::build("blob");
    if (!blob) {
        return blob.error();
    }
    m_program = std::move(blob).value();
    std::array<glm::vec2, kBlobCorners> corners{};
    for (int i = 0; i < kBlobCorners; ++i) {
        const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(kBlobCorners);
        // Out to where the octagon's edges touch the circle.
        corners[static_cast<std::size_t>(i)] =
            glm::vec2(std::cos(angle), -std::sin(angle)) * 1.0824F;
    }
    m_array = GlVertexArray::create();
    glBindVertexArray(m_array.name());
    m_corners = makeBuffer(GL_ARRAY_BUFFER, std::as_bytes(std::span(corners)));
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(4);
    glVertexAttribDivisor(4, 1);
    glBindVertexArray(0);
    return {};
}

/// Under everybody but those at the coarsest level, whose shadows would be a pixel or two.
void BlobPass::draw(const PassContext& context, const CrowdRows& rows, const CrowdView& view)
{
    std::size_t count = 0;
    for (const InstanceRun& run : view.runs()) {
        if (run.level < model::kMaxLevels - 1) {
            count = run.first + run.count;
        }
    }
    if (count == 0) {
        return;
    }
    m_program.use();
    context.setCommon(m_program);
    m_program.set("placement", kPlacementUnit);
    m_program.set("appearance", kAppearanceUnit);
    m_program.set("strength", context.style.blobStrength);
    rows.placement.bind(kPlacementUnit);
    rows.appearance.bind(kAppearanceUnit);
    glBindVertexArray(m_array.name());
    glBindBuffer(GL_ARRAY_BUFFER, view.instances().name());
    glVertexAttribIPointer(4, 4, GL_UNSIGNED_INT, sizeof(Instance), nullptr);
    glEnable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0F, -2.0F);
    glDepthMask(GL_FALSE);
    glDrawArraysInstanced(GL_TRIANGLE_FAN, 0, kBlobCorners, static_cast<GLsizei>(count));
    context.countDraw(static_cast<std::int64_t>(kBlobCorners - 2) *
                      static_cast<std::int64_t>(count));
    glDepthMask(GL_TRUE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_BLEND);
}

} // namespace crowd::render
