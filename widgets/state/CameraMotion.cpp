// SPDX-License-Identifier: MIT
#include "widgets/state/CameraMotion.h"

#include <algorithm>

#include "model/view/CameraWays.h"

namespace crowd::widgets {

using model::Camera;

void CameraMotion::start(const Camera& from, const Camera& to, double seconds)
{
    m_way = Way{from, to, seconds, 0.0};
}

std::optional<Camera> CameraMotion::target() const
{
    return m_way ? std::optional(m_way->to) : std::nullopt;
}

Camera CameraMotion::advance(double realSeconds)
{
    if (!m_way) {
        return {};
    }
    m_way->seconds += std::max(realSeconds, 0.0);
    const auto t = static_cast<float>(std::min(m_way->seconds / m_way->length, 1.0));
    // Leaves at once and arrives gently: a motion that takes over from another does not stall.
    const float rest = 1.0F - t;
    const Camera camera = blended(m_way->from, m_way->to, 1.0F - rest * rest * rest);
    if (t >= 1.0F) {
        m_way.reset();
    }
    return camera;
}

} // namespace crowd::widgets
