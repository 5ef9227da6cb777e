// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "render/RenderInput.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// The lamps of all lights while one of them is chosen, and that one's cone with what it aims at.
/// Metres, world frame.
class LightMarks
{
public:
    void make(const EditorState& state, const model::CrowdFrame& frame);
    [[nodiscard]] std::span<const render::OverlayLine> lines() const { return m_lines; }

private:
    void addLamp(const model::Light& light, const glm::vec4& color, const model::Camera& camera);
    void addCone(const model::Light& light, const glm::vec3& target, const glm::vec4& color);
    void addCross(const glm::vec3& at, float metres, const glm::vec4& color);

    std::vector<render::OverlayLine> m_lines;
};

} // namespace crowd::widgets
