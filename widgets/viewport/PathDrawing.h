// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/view/View.h"
#include "render/RenderInput.h"
#include "widgets/state/EditorState.h"
#include "widgets/viewport/GroundSheets.h"

namespace crowd::widgets {

/// Places as rings, lines and areas, and paths as lanes with arrows, laid on the ground, with the
/// way around what is in between; branches from one path to another. Made anew only when they
/// changed.
class PathDrawing
{
public:
    /// Triangles of everything, topmost first; the current path has a bright border, selected
    /// places a bright ring.
    [[nodiscard]] std::span<const render::OverlayTriangle> areas(const EditorState& state,
                                                                 const model::StageRays& stage);
    /// Another one for other areas; never 0 once they were asked for.
    [[nodiscard]] std::uint64_t version() const { return m_version; }
    /// Something else is to be drawn.
    void forget() { m_isStale = true; }

private:
    /// From the top: who lies above colours a pixel alone.
    enum class Layer : std::uint8_t {
        Branch,
        SelectedRing,
        Ring,
        Way,
        Arrow,
        Disc,
        CurrentLane,
        CurrentBorder,
        Lane,
        Count
    };

    void draw(const EditorState& state, const model::StageRays& stage);
    void path(const EditorState& state, const model::Path& path);
    void place(const model::Place& place, bool isSelected);
    void disc(const model::Place& place, glm::vec4 fill, bool isSelected);
    void line(const model::Place& place, glm::vec4 fill, bool isSelected);
    void area(const model::Place& place, glm::vec4 fill, bool isSelected);
    void corners(const model::Place& place);
    void leg(const model::Place& from, const model::Place& to, glm::vec3 color, bool isCurrent);
    void way(const std::vector<glm::vec3>& corners, const model::Place& from,
             const model::Place& to, glm::vec3 color);
    void arrows(const model::Place& from, const model::Place& to, glm::vec4 color);
    void branch(const model::Scene& scene, const model::PathBranch& branch, int number);
    void arrow(const glm::vec3& tip, const glm::vec3& along, float size, Layer layer,
               glm::vec4 color);
    void band(const BandShape& shape, Layer layer, glm::vec4 color);
    void ring(const RingShape& shape, Layer layer, glm::vec4 color);
    void add(Layer layer, const std::vector<GroundTriangle>& triangles, glm::vec4 color);

    GroundSheets m_sheets;
    std::array<std::vector<render::OverlayTriangle>, static_cast<std::size_t>(Layer::Count)>
        m_layers;
    std::vector<render::OverlayTriangle> m_areas;
    std::uint64_t m_version = 0;
    bool m_isStale = true;
};

} // namespace crowd::widgets
