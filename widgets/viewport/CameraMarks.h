// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "render/RenderInput.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// The timeline's camera while the view does not look through it: the ways that it takes, where it
/// comes to, and where it is at the moment that is shown. Metres, world frame.
class CameraMarks
{
public:
    void make(EditorState& state);
    [[nodiscard]] std::span<const render::OverlayLine> lines() const { return m_lines; }

private:
    void addWay(const model::CameraTrack& track, const model::CameraTrack::Move& move);
    void addCamera(const model::Camera& camera, float metres, const glm::vec4& color);

    std::vector<render::OverlayLine> m_lines;
};

} // namespace crowd::widgets
