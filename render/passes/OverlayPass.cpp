// SPDX-License-Identifier: MIT
#include "render/passes/OverlayPass.h"

#include <array>
#include <vector>

#include <epoxy/gl.h>

#include "model/base/Color.h"

namespace crowd::render {

namespace {

constexpr float kMarkerLift = 0.03F;   ///< metres above what it marks
constexpr float kHiddenOpacity = 0.3F; ///< of lines behind something
constexpr float kRibbonRim = 1.5F;     ///< logical pixels
constexpr float kHiddenAreaOpacity = 0.2F;
constexpr float kHiddenRingOpacity = 0.5F;
constexpr float kRingPull = 0.15F; ///< as kAreaPull; feet stay in front of it
/// Metres that areas are taken for nearer than they are: ground that is a little uneven does not
/// swallow them.
constexpr float kAreaPull = 0.3F;
constexpr float kGroundPull = 0.1F; ///< as kAreaPull: the step above a floor is not taken for it
constexpr int kAreaStencil = 1;     ///< an area is drawn there already

struct MarkerVertex
{
    glm::vec4 positionAndRadius{0.0F};
    glm::vec4 color{1.0F};
    glm::vec4 shape{0.0F, 0.0F, 1.0F, 0.0F}; ///< as in marker.vert
};

struct LineVertex
{
    glm::vec3 position{0.0F};
    glm::vec4 color{1.0F};
};

struct RibbonVertex
{
    glm::vec4 fromAndWidth{0.0F};
    glm::vec4 toAndWidth{0.0F};
    glm::vec4 color{1.0F};
};

glm::vec4 linear(const glm::vec4& srgb)
{
    return {model::linearFromSrgb(glm::vec3(srgb)), srgb.w};
}

/// Towards the eye: from a point minus w times it.
glm::vec4 eyeOf(const model::Camera& camera)
{
    return camera.projection == model::Projection::Orthographic ? glm::vec4(-camera.forward(), 0.0F)
                                                                : glm::vec4(camera.position, 1.0F);
}

void describeLines(const GlVertexArray& array, const GlBuffer& buffer)
{
    glBindVertexArray(array.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(LineVertex), nullptr);
    glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, sizeof(LineVertex),
                          bufferOffset(sizeof(glm::vec3)));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
}

} // namespace

model::Result<void> OverlayPass::initialize()
{
    auto marker = ShaderProgram::build("marker");
    if (!marker) {
        return marker.error();
    }
    auto line = ShaderProgram::build("line");
    if (!line) {
        return line.error();
    }
    auto ribbon = ShaderProgram::build("ribbon");
    if (!ribbon) {
        return ribbon.error();
    }
    m_marker = std::move(marker).value();
    m_ribbon = std::move(ribbon).value();
    m_line = std::move(line).value();
    m_markers = GlBuffer::create();
    m_ribbons = GlBuffer::create();
    constexpr std::array<glm::vec2, 4> kCorners{
        {{-1.0F, -1.0F}, {-1.0F, 1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}}};
    m_corners = makeBuffer(GL_ARRAY_BUFFER, std::as_bytes(std::span(kCorners)));
    for (GlVertexArray* array : {&m_markerArray, &m_ribbonArray}) {
        *array = GlVertexArray::create();
        glBindVertexArray(array->name());
        glBindBuffer(GL_ARRAY_BUFFER, m_corners.name());
        glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
        for (GLuint attribute = 0; attribute < 4; ++attribute) {
            glEnableVertexAttribArray(attribute);
            glVertexAttribDivisor(attribute, attribute == 0 ? 0 : 1);
        }
    }
    m_areas.initialize();
    m_ground.initialize();
    glBindVertexArray(0);
    return {};
}

void OverlayPass::draw(const PassContext& context)
{
    glEnable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
    drawAreas(context);
    drawMarkers(context);
    drawLines(context);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

/// Discs first, then rings: those are drawn a second time where something hides them.
void OverlayPass::drawMarkers(const PassContext& context)
{
    if (context.input.markers.empty()) {
        return;
    }
    std::vector<MarkerVertex> vertices;
    vertices.reserve(context.input.markers.size());
    const auto add = [&](bool isRing) {
        for (const Marker& marker : context.input.markers) {
            if ((marker.innerShare > 0.0F) == isRing) {
                const glm::vec3 lifted = marker.position + glm::vec3(0.0F, kMarkerLift, 0.0F);
                vertices.push_back(
                    {glm::vec4(lifted, marker.radius),
                     linear(marker.color),
                     {marker.innerShare, marker.fromTurn, marker.toTurn, marker.leastPixels}});
            }
        }
    };
    add(false);
    const std::size_t discs = vertices.size();
    add(true);
    stream(m_markers, std::as_bytes(std::span(vertices)));
    m_marker.use();
    context.setCommon(m_marker);
    const model::View& view = context.input.view;
    m_marker.set("metresPerPixel", 2.0F / (view.projectionMatrix()[1][1] * view.size().y));
    m_marker.set("opacity", 1.0F);
    m_marker.set("eye", eyeOf(view.camera()));
    m_marker.set("pull", kRingPull);
    glBindVertexArray(m_markerArray.name());
    drawMarkers(context, 0, vertices.size());
    if (vertices.size() > discs) {
        m_marker.set("opacity", kHiddenRingOpacity);
        glDepthFunc(GL_GREATER);
        drawMarkers(context, discs, vertices.size() - discs);
        glDepthFunc(GL_LEQUAL);
    }
}

void OverlayPass::drawMarkers(const PassContext& context, std::size_t first, std::size_t count)
{
    const std::size_t at = first * sizeof(MarkerVertex);
    glBindBuffer(GL_ARRAY_BUFFER, m_markers.name());
    for (GLuint part = 0; part < 3; ++part) {
        glVertexAttribPointer(part + 1, 4, GL_FLOAT, GL_FALSE, sizeof(MarkerVertex),
                              bufferOffset(at + part * sizeof(glm::vec4)));
    }
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
    context.countDraw(static_cast<std::int64_t>(count) * 2);
}

void OverlayPass::Areas::initialize()
{
    corners = GlBuffer::create();
    array = GlVertexArray::create();
    describeLines(array, corners);
}

void OverlayPass::Areas::send(std::span<const OverlayTriangle> areas, std::uint64_t now)
{
    if (now != 0 && now == version) {
        return;
    }
    version = now;
    std::vector<LineVertex> vertices;
    vertices.reserve(areas.size() * 3);
    for (const OverlayTriangle& area : areas) {
        for (const glm::vec3& corner : area.corners) {
            vertices.push_back({corner, linear(area.color)});
        }
    }
    stream(corners, std::as_bytes(std::span(vertices)));
}

/// Each sample is coloured once, by the first triangle that covers it; what is seen goes before
/// what is hidden.
void OverlayPass::drawAreas(const PassContext& context)
{
    const RenderInput& input = context.input;
    if (input.areas.empty() && input.groundAreas.empty()) {
        return;
    }
    m_line.use();
    context.setCommon(m_line);
    m_line.set("eye", eyeOf(input.view.camera()));
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_GREATER, kAreaStencil, 0xFFU);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    const auto draw = [&](const Areas& areas, std::size_t triangles, float pull, float opacity) {
        m_line.set("pull", pull);
        m_line.set("opacity", opacity);
        glBindVertexArray(areas.array.name());
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles * 3));
        context.countDraw(static_cast<std::int64_t>(triangles));
    };
    if (!input.areas.empty()) {
        m_areas.send(input.areas, input.areasVersion);
        draw(m_areas, input.areas.size(), kAreaPull, 1.0F);
    }
    if (!input.groundAreas.empty()) {
        m_ground.send(input.groundAreas, input.groundAreasVersion);
        draw(m_ground, input.groundAreas.size(), kGroundPull, 1.0F);
    }
    if (!input.areas.empty()) {
        glDepthFunc(GL_GREATER);
        draw(m_areas, input.areas.size(), kAreaPull, kHiddenAreaOpacity);
        glDepthFunc(GL_LEQUAL);
    }
    glDisable(GL_STENCIL_TEST);
}

void OverlayPass::drawLines(const PassContext& context)
{
    if (context.input.lines.empty()) {
        return;
    }
    std::vector<RibbonVertex> ribbons;
    ribbons.reserve(context.input.lines.size());
    for (const OverlayLine& line : context.input.lines) {
        ribbons.push_back({glm::vec4(line.from, line.fromPixels), glm::vec4(line.to, line.toPixels),
                           linear(line.color)});
    }
    stream(m_ribbons, std::as_bytes(std::span(ribbons)));
    m_ribbon.use();
    context.setCommon(m_ribbon);
    m_ribbon.set("viewSize", context.input.view.size());
    m_ribbon.set("rim", kRibbonRim);
    glBindVertexArray(m_ribbonArray.name());
    glBindBuffer(GL_ARRAY_BUFFER, m_ribbons.name());
    for (GLuint part = 0; part < 3; ++part) {
        glVertexAttribPointer(part + 1, 4, GL_FLOAT, GL_FALSE, sizeof(RibbonVertex),
                              bufferOffset(part * sizeof(glm::vec4)));
    }
    const auto draw = [&](GLenum depth, float opacity) {
        m_ribbon.set("opacity", opacity);
        glDepthFunc(depth);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(ribbons.size()));
        context.countDraw(static_cast<std::int64_t>(ribbons.size()) * 2);
    };
    draw(GL_GREATER, kHiddenOpacity);
    draw(GL_LEQUAL, 1.0F);
}

} // namespace crowd::render
