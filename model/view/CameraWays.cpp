// SPDX-License-Identifier: MIT
#include "model/view/CameraWays.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/spline.hpp>

namespace crowd::model {

namespace {

constexpr float kSamePlace = 1e-3F; ///< metres

/// The same view from a place, in another direction.
Camera facing(const Camera& camera, const glm::vec3& from, const glm::vec3& way)
{
    Camera moved = camera;
    moved.position = from;
    if (glm::length(way) > kSamePlace) {
        moved.orientation = Camera::lookingAt(from, from + way).orientation;
    }
    return moved;
}

} // namespace

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

Camera goneAround(const Camera& camera, float radians)
{
    Camera turned = camera;
    if (radians == 0.0F) {
        return turned; // to the last bit
    }
    const glm::quat turn = glm::angleAxis(radians, glm::vec3(0.0F, 1.0F, 0.0F));
    turned.orientation = glm::normalize(turn * camera.orientation);
    turned.position = camera.pivot() - turned.forward() * camera.pivotDistance;
    return turned;
}

CameraRail::CameraRail(const std::vector<glm::vec3>& points, bool isClosed) : m_isClosed(isClosed)
{
    for (const glm::vec3& each : points) {
        if (m_points.empty() || glm::distance(m_points.back(), each) > kSamePlace) {
            m_points.push_back(each);
        }
    }
    if (m_isClosed && m_points.size() > 1 &&
        glm::distance(m_points.front(), m_points.back()) <= kSamePlace) {
        m_points.pop_back();
    }
    m_isClosed = m_isClosed && m_points.size() > 2;
    measure();
}

std::size_t CameraRail::pieces() const
{
    return m_isClosed ? m_points.size() : m_points.size() - 1;
}

/// Around where it is closed; else the ends go on.
glm::vec3 CameraRail::point(std::ptrdiff_t index) const
{
    const auto count = static_cast<std::ptrdiff_t>(m_points.size());
    const std::ptrdiff_t near =
        m_isClosed ? (index + count) % count : std::clamp<std::ptrdiff_t>(index, 0, count - 1);
    return m_points[static_cast<std::size_t>(near)];
}

/// Metres a metre.
glm::vec3 CameraRail::tangent(std::size_t index) const
{
    const auto at = static_cast<std::ptrdiff_t>(index);
    const glm::vec3 before = point(at) - point(at - 1);
    const glm::vec3 after = point(at + 1) - point(at);
    const float lengthBefore = glm::length(before);
    const float lengthAfter = glm::length(after);
    if (lengthBefore <= kSamePlace || lengthAfter <= kSamePlace) { // an end
        return glm::normalize(before + after);
    }
    return (before / lengthBefore * lengthAfter + after / lengthAfter * lengthBefore) /
           (lengthBefore + lengthAfter);
}

glm::vec3 CameraRail::onPiece(std::size_t piece, float t) const
{
    const auto at = static_cast<std::ptrdiff_t>(piece);
    const glm::vec3 from = point(at);
    const glm::vec3 to = point(at + 1);
    const float chord = glm::distance(from, to);
    const std::size_t next = (piece + 1) % m_points.size();
    return glm::hermite(from, tangent(piece) * chord, to, tangent(next) * chord, t);
}

void CameraRail::measure()
{
    if (isEmpty()) {
        return;
    }
    m_lengths.push_back(0.0);
    glm::vec3 last = m_points.front();
    for (std::size_t piece = 0; piece < pieces(); ++piece) {
        for (int i = 1; i <= kSamples; ++i) {
            const glm::vec3 next =
                onPiece(piece, static_cast<float>(i) / static_cast<float>(kSamples));
            m_lengths.push_back(m_lengths.back() + static_cast<double>(glm::distance(last, next)));
            last = next;
        }
    }
}

CameraRail::Spot CameraRail::at(float share) const
{
    const double along = length() * static_cast<double>(std::clamp(share, 0.0F, 1.0F));
    const auto after = std::upper_bound(m_lengths.begin() + 1, m_lengths.end() - 1, along);
    const auto sample = static_cast<std::size_t>(after - m_lengths.begin()) - 1;
    const auto samples = static_cast<std::size_t>(kSamples);
    const std::size_t piece = sample / samples;
    const auto begin = static_cast<float>(sample % samples) / static_cast<float>(kSamples);
    const auto end = static_cast<float>(sample % samples + 1) / static_cast<float>(kSamples);
    const glm::vec3 from = onPiece(piece, begin);
    const glm::vec3 to = onPiece(piece, end);
    const double room = std::max(m_lengths[sample + 1] - m_lengths[sample], 1e-9);
    const auto t = static_cast<float>(std::min((along - m_lengths[sample]) / room, 1.0));
    return {onPiece(piece, glm::mix(begin, end, t)), glm::normalize(to - from)};
}

Camera onRail(const Camera& camera, const CameraRail& rail, const RailPlace& place)
{
    const CameraRail::Spot spot = rail.at(place.share);
    const glm::vec3 position = spot.position + glm::vec3(0.0F, place.above, 0.0F);
    return facing(camera, position, place.looksAhead ? spot.direction : camera.pivot() - position);
}

} // namespace crowd::model
