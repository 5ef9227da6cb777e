// SPDX-License-Identifier: MIT
#include "widgets/state/CameraMotion.h"

#include <algorithm>

#include <glm/common.hpp>

namespace crowd::widgets {

using model::Camera;

Camera blended(const Camera& from, const Camera& to, float t)
{
    if (t >= 1.0F) {
        return to;
    }
    Camera camera = to;
    camera.orientation = glm::normalize(glm::slerp(from.orientation, to.orientation, t));
    camera.pivotDistance = glm::mix(from.pivotDistance, to.pivotDistance, t);
    camera.fovYRadians = glm::mix(from.fovYRadians, to.fovYRadians, t);
    camera.orthographicHeight = glm::mix(from.orthographicHeight, to.orthographicHeight, t);
    const glm::vec3 pivot = glm::mix(from.pivot(), to.pivot(), t);
    camera.position = pivot - camera.forward() * camera.pivotDistance;
    return camera;
}

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
