// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "widgets/state/EditorState.h"
#include "widgets/viewport/PeopleMarks.h"

namespace crowd::widgets {

/// Relations as arcs over the heads, in the colours of their kinds, of a frame: of the selected;
/// of everybody where nobody is selected or the brush works on them. Those that are not mutual have
/// a head. Of very many the first ones are drawn. Metres, world frame.
class RelationArcs
{
public:
    void make(const EditorState& state, const model::CrowdFrame& frame);
    [[nodiscard]] std::span<const render::OverlayLine> lines() const { return m_lines; }
    /// Kinds of which there are arcs.
    [[nodiscard]] const std::vector<TagLabel>& legend() const { return m_legend; }

private:
    struct Arc
    {
        glm::vec3 from{0.0F};
        glm::vec3 to{0.0F};
        const model::RelationKind* kind = nullptr;
        float strength = 1.0F;
    };
    void gather(const EditorState& state, const model::CrowdFrame& frame);
    void draw(const Arc& arc, int segments);

    std::vector<Arc> m_arcs;
    std::vector<render::OverlayLine> m_lines;
    std::vector<TagLabel> m_legend;
};

} // namespace crowd::widgets
