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
    /// Areas as they were sent last.
    struct Areas
    {
        GlVertexArray array;
        GlBuffer corners;
        std::uint64_t version = 0; ///< 0: unknown

        void initialize();
        void send(std::span<const OverlayTriangle> areas, std::uint64_t now);
    };

    void drawMarkers(const PassContext& context);
    void drawMarkers(const PassContext& context, std::size_t first, std::size_t count);
    void drawAreas(const PassContext& context);
    void drawLines(const PassContext& context);

    ShaderProgram m_marker;
    ShaderProgram m_line;   ///< of areas
    ShaderProgram m_ribbon; ///< of lines
    GlVertexArray m_markerArray;
    GlVertexArray m_ribbonArray;
    GlBuffer m_corners;
    GlBuffer m_markers;
    GlBuffer m_ribbons;
    Areas m_areas;
    Areas m_ground;
};

} // namespace crowd::render
