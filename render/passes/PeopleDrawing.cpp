// SPDX-License-Identifier: MIT
#include "render/passes/PeopleDrawing.h"

#include <algorithm>
#include <utility>

#include <epoxy/gl.h>

#include "render/crowd/EarlierRows.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr int kTemplateUnit = kAppearanceUnit + 1; ///< and the two after it
constexpr int kPicturesUnit = kTemplateUnit + 3;
/// A software rasteriser works on what was flushed while the next piece is prepared.
constexpr std::size_t kSoftwarePiece = 100;

} // namespace

PeopleDrawing::PeopleDrawing()
    : m_programs("crowd", [](ShaderProgram& program) {
          program.set("placement", kPlacementUnit);
          program.set("appearance", kAppearanceUnit);
          program.set("keyframes", kTemplateUnit);
          program.set("clipBoxes", kTemplateUnit + 1);
          program.set("materials", kTemplateUnit + 2);
          program.set("images", kPicturesUnit);
          program.set("earlier", kEarlierUnit);
      })
{
}

void PeopleDrawing::setUniforms(const PassContext& context, const CrowdDraw& drawing,
                                const TemplateGpu& gpu, std::uint32_t verticesPerKeyframe,
                                ShaderProgram& shader) const
{
    context.setCommon(shader);
    shader.set("verticesPerKeyframe", verticesPerKeyframe);
    shader.set("choicesPerSlot", gpu.choicesPerSlot());
    shader.set("tintableSlots", gpu.tintableSlots());
    shader.set("opacity", drawing.opacity);
    if (context.style.paint) {
        shader.set("paint", context.style.paint->people);
    }
}

void PeopleDrawing::drawGroup(const PassContext& context, const MeshGroup& group,
                              const InstanceRun& run) const
{
    const std::size_t piece = context.isSoftware ? kSoftwarePiece : run.count;
    const auto* indices = bufferOffset(group.firstIndex * sizeof(std::uint32_t));
    for (std::size_t done = 0; done < run.count; done += piece) {
        const std::size_t count = std::min(piece, run.count - done);
        const std::size_t offset = (run.first + done) * sizeof(Instance);
        glVertexAttribIPointer(4, 4, GL_UNSIGNED_INT, sizeof(Instance), bufferOffset(offset));
        glVertexAttribPointer(5, 1, GL_FLOAT, GL_FALSE, sizeof(Instance),
                              bufferOffset(offset + offsetof(Instance, blend)));
        glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(group.indexCount),
                                GL_UNSIGNED_INT, indices, static_cast<GLsizei>(count));
        context.countDraw(static_cast<std::int64_t>(group.indexCount / 3) *
                          static_cast<std::int64_t>(count));
        if (context.isSoftware && count == piece) {
            glFlush();
        }
    }
}

Result<void> PeopleDrawing::draw(const PassContext& context, const CrowdDraw& drawing,
                                 const TemplateGpu& gpu, const InstanceRun& run)
{
    const TemplateGpu::Level& level = gpu.level(run.level);
    drawing.rows.placement.bind(kPlacementUnit);
    drawing.rows.appearance.bind(kAppearanceUnit);
    if (context.earlier != nullptr) {
        context.earlier->bind(kEarlierUnit);
    }
    gpu.bindTables(run.level, kTemplateUnit);
    glBindVertexArray(level.array.name());
    glBindBuffer(GL_ARRAY_BUFFER, drawing.instances.name());
    for (const MeshGroup& group : level.groups) {
        const bool isSeeThrough = drawing.surface == Surface::SeeThrough;
        if (isSeeThrough && group.state.alphaMode != AlphaMode::Blend) {
            continue;
        }
        auto shader = m_programs.get(drawing.defines + definesOf(group.state, drawing.surface));
        if (!shader) {
            return shader.error();
        }
        shader.value()->use();
        setUniforms(context, drawing, gpu, level.verticesPerKeyframe, *shader.value());
        gpu.bindPictures(group.state.pictures, kPicturesUnit);
        const bool isCulled = !group.state.isDoubleSided;
        (isCulled ? glEnable : glDisable)(GL_CULL_FACE);
        (isSeeThrough || drawing.opacity < 1.0F ? glEnable : glDisable)(GL_BLEND);
        drawGroup(context, group, run);
    }
    return {};
}

} // namespace crowd::render
