// SPDX-License-Identifier: MIT
#include "widgets/viewport/WalkableDrawing.h"

namespace crowd::widgets {

namespace {

constexpr glm::vec4 kWalkableColor{0.12F, 0.62F, 0.72F, 0.38F};

} // namespace

std::span<const render::OverlayTriangle>
WalkableDrawing::areas(const model::WalkableGroundPtr& ground)
{
    if (m_version != 0 && ground == m_ground) {
        return m_areas;
    }
    m_ground = ground;
    ++m_version;
    m_areas.clear();
    if (ground) {
        for (const auto& corners : ground->triangles()) {
            m_areas.push_back({corners, kWalkableColor});
        }
    }
    return m_areas;
}

} // namespace crowd::widgets
