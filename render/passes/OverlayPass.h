// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/gl/GlObjects.h"
#include "render/gl/ShaderProgram.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// Discs and lines that tools show in the scene.
class OverlayPass
{
public:
    [[nodiscard]] model::Result<void> initialize();
    void draw(const PassContext& context);

private:
    void drawMarkers(const PassContext& context);
    void drawAreas(const PassContext& context);
    void drawLines(const PassContext& context);

    ShaderProgram m_marker;
    ShaderProgram m_line;
    GlVertexArray m_markerArray;
    GlVertexArray m_lineArray;
    GlBuffer m_corners;
    GlBuffer m_markers;
    GlBuffer m_lines;
};

} // namespace crowd::render
