// SPDX-License-Identifier: MIT
#include "widgets/viewport/WalkableDrawing.h"

namespace crowd::widgets {

namespace {

constexpr glm::vec4 kWalkableColor{0.12F, 0.62F, 0.72F, 0.38F};
constexpr std::uint64_t kOwnVersions = std::uint64_t{1} << 62; ///< others count from 1

} // namespace

std::span<const render::OverlayTriangle>
WalkableDrawing::areas(const model::WalkableGroundPtr& ground,
                       std::span<const render::OverlayTriangle> above, std::uint64_t aboveVersion)
{
    if (m_version != 0 && ground == m_ground && aboveVersion == m_aboveVersion) {
        return m_areas;
    }
    m_ground = ground;
    m_aboveVersion = aboveVersion;
    m_version = m_version == 0 ? kOwnVersions : m_version + 1;
    m_areas.assign(above.begin(), above.end());
    if (ground) {
        for (const auto& corners : ground->triangles()) {
            m_areas.push_back({corners, kWalkableColor});
        }
    }
    return m_areas;
}

} // namespace crowd::widgets
