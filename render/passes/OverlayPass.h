// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderProgram.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// In the stencil where people are seen: areas are not drawn over them.
inline constexpr int kPeopleStencil = 0x80;

/// Discs, areas and lines that tools show in the scene.
class OverlayPass
{
public:
    [[nodiscard]] model::Result<void> initialize();
    void draw(const PassContext& context);

private:
    void drawMarkers(const PassContext& context);
    void drawMarkers(const PassContext& context, std::size_t first, std::size_t count);
    void sendAreas(const PassContext& context);
    void drawAreas(const PassContext& context);
    void drawLines(const PassContext& context);

    ShaderProgram m_marker;
    ShaderProgram m_line;
    GlVertexArray m_markerArray;
    GlVertexArray m_lineArray;
    GlVertexArray m_areaArray;
    GlBuffer m_corners;
    GlBuffer m_markers;
    GlBuffer m_lines;
    GlBuffer m_areas;
    std::uint64_t m_areasVersion = 0; ///< what is in m_areas; 0: unknown
};

} // namespace crowd::render
