// SPDX-License-Identifier: MIT
#include "render/passes/PeopleDrawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <epoxy/gl.h>

#include "render/crowd/EarlierRows.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr int kTemplateUnit = kAppearanceUnit + 1; ///< and the two after it
constexpr int kPicturesUnit = kTemplateUnit + 3;
constexpr int kCardsUnit = kPicturesUnit + 1;
constexpr int kInstancesUnit = kEarlierUnit + 1;
constexpr int kCardCorners = 6; ///< of two triangles
/// A software rasteriser works on what was flushed while the next piece is prepared.
constexpr std::size_t kSoftwarePiece = 100;

} // namespace

PeopleDrawing::PeopleDrawing()
    : m_programs("crowd",
                 [](ShaderProgram& program) {
                     program.set("placement", kPlacementUnit);
                     program.set("appearance", kAppearanceUnit);
                     program.set("keyframes", kTemplateUnit);
                     program.set("clipBoxes", kTemplateUnit + 1);
                     program.set("materials", kTemplateUnit + 2);
                     program.set("images", kPicturesUnit);
                     program.set("earlier", kEarlierUnit);
                 }),
      m_cardPrograms("impostor", [](ShaderProgram& program) {
          program.set("placement", kPlacementUnit);
          program.set("appearance", kAppearanceUnit);
          program.set("cardTexels", kTemplateUnit);
          program.set("cardSets", kTemplateUnit + 1);
          program.set("instances", kInstancesUnit);
          program.set("cards", kCardsUnit);
          program.set("materials", kTemplateUnit + 2);
          program.set("images", kPicturesUnit);
      })
{
}

void PeopleDrawing::setUniforms(const PassContext& context, const CrowdDraw& drawing,
                                const TemplateGpu& gpu, ShaderProgram& shader) const
{
    context.setCommon(shader);
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

/// As words.
void PeopleDrawing::bindInstances(const GlBuffer& instances)
{
    if (!m_instanceWords) {
        m_instanceWords = GlTexture::create();
    }
    glActiveTexture(GL_TEXTURE0 + kInstancesUnit);
    glBindTexture(GL_TEXTURE_BUFFER, m_instanceWords.name());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, instances.name());
}

/// Of everything they show; there are none of people with something to see through.
Result<void> PeopleDrawing::drawCards(const PassContext& context, const CrowdDraw& drawing,
                                      const TemplateGpu& gpu, const InstanceRun& run)
{
    const ImpostorGpu& impostors = gpu.impostors();
    auto shader = m_cardPrograms.get("IMPOSTOR " + impostors.defines() + drawing.defines +
                                     definesOf(impostors.state(), drawing.surface));
    if (!shader) {
        return shader.error();
    }
    ShaderProgram& program = *shader.value();
    program.use();
    setUniforms(context, drawing, gpu, program);
    const View& view = drawing.seenFrom != nullptr ? *drawing.seenFrom : context.input.view;
    const bool isPerspective = view.camera().projection == Projection::Perspective;
    program.set("cardEye", isPerspective ? glm::vec4(view.camera().position, 1.0F)
                                         : glm::vec4(-view.camera().forward(), 0.0F));
    program.set("lastPictureLevel", std::floor(std::log2(gpu.pictureTexels())));
    program.set("texelsPerPixel",
                impostors.pictureSharePerMetre() * gpu.pictureTexels() * 2.0F /
                    (view.projectionMatrix()[1][1] * static_cast<float>(context.pixelSize.y)));
    drawing.rows.placement.bind(kPlacementUnit);
    drawing.rows.appearance.bind(kAppearanceUnit);
    gpu.bindTables(0, kTemplateUnit);
    impostors.bind(kTemplateUnit, kTemplateUnit + 1, kCardsUnit);
    gpu.bindPictures(impostors.state().pictures, kPicturesUnit);
    bindInstances(drawing.instances);
    program.set("firstInstance", static_cast<int>(run.first));
    glBindVertexArray(impostors.array().name());
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, kCardCorners * static_cast<GLsizei>(run.count));
    context.countDraw(2 * static_cast<std::int64_t>(run.count));
    return {};
}

Result<void> PeopleDrawing::draw(const PassContext& context, const CrowdDraw& drawing,
                                 const TemplateGpu& gpu, const InstanceRun& run)
{
    if (run.level == kImpostorLevel) {
        return drawCards(context, drawing, gpu, run);
    }
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
        setUniforms(context, drawing, gpu, *shader.value());
        shader.value()->set("verticesPerKeyframe", level.verticesPerKeyframe);
        gpu.bindPictures(group.state.pictures, kPicturesUnit);
        const bool isCulled = !group.state.isDoubleSided;
        (isCulled ? glEnable : glDisable)(GL_CULL_FACE);
        (isSeeThrough || drawing.opacity < 1.0F ? glEnable : glDisable)(GL_BLEND);
        drawGroup(context, group, run);
    }
    return {};
}

} // namespace crowd::render
