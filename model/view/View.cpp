// SPDX-License-Identifier: MIT
#include "model/view/View.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace crowd::model {

namespace {

constexpr float kNear = 0.1F;
constexpr float kFar = 3000.0F;

glm::mat4 projectionOf(const Camera& camera, glm::vec2 size)
{
    const float aspect = size.x / size.y;
    if (camera.projection == Projection::Perspective) {
        return glm::perspectiveRH_NO(camera.fovYRadians, aspect, kNear, kFar);
    }
    const float halfHeight = camera.orthographicHeight * 0.5F;
    // An orthographic camera also sees what lies behind its position.
    return glm::orthoRH_NO(-halfHeight * aspect, halfHeight * aspect, -halfHeight, halfHeight,
                           -kFar, kFar);
}

} // namespace

glm::vec3 Camera::forward() const
{
    return orientation * glm::vec3(0.0F, 0.0F, -1.0F);
}

glm::vec3 Camera::up() const
{
    return orientation * glm::vec3(0.0F, 1.0F, 0.0F);
}

glm::vec3 Camera::right() const
{
    return orientation * glm::vec3(1.0F, 0.0F, 0.0F);
}

glm::vec3 Camera::pivot() const
{
    return position + forward() * pivotDistance;
}

Camera Camera::lookingAt(const glm::vec3& from, const glm::vec3& at)
{
    Camera camera;
    camera.position = from;
    const glm::vec3 way = at - from;
    camera.pivotDistance = std::max(glm::length(way), 0.01F);
    const glm::vec3 direction = way / camera.pivotDistance;
    const bool isVertical = std::abs(direction.y) > 0.9999F;
    camera.orientation = glm::quatLookAtRH(direction, isVertical ? glm::vec3(0.0F, 0.0F, -1.0F)
                                                                 : glm::vec3(0.0F, 1.0F, 0.0F));
    camera.orthographicHeight = 2.0F * camera.pivotDistance * std::tan(camera.fovYRadians * 0.5F);
    return camera;
}

View::View(const Camera& camera, glm::vec2 sizePixels)
    : m_camera(camera), m_size(glm::max(sizePixels, glm::vec2(1.0F))), m_wholeSize(m_size),
      m_near(camera.projection == Projection::Perspective ? kNear : -kFar),
      m_view(glm::mat4_cast(glm::conjugate(camera.orientation)) *
             glm::translate(glm::mat4(1.0F), -camera.position)),
      m_projection(projectionOf(camera, m_size)), m_viewProjection(m_projection * m_view)
{
}

View View::part(glm::vec2 corner, glm::vec2 sizePixels) const
{
    View part = *this;
    part.m_size = glm::max(sizePixels, glm::vec2(1.0F));
    part.m_corner = corner;
    const glm::vec2 scale = m_size / part.m_size;
    const glm::vec2 aside = (m_size - 2.0F * corner - part.m_size) / part.m_size;
    const glm::mat4 moved = glm::translate(glm::mat4(1.0F), {aside.x, -aside.y, 0.0F});
    part.m_projection = glm::scale(moved, {scale.x, scale.y, 1.0F}) * m_projection;
    part.m_viewProjection = part.m_projection * m_view;
    return part;
}

std::optional<glm::vec3> View::project(const glm::vec3& world) const
{
    const glm::vec4 eye = m_view * glm::vec4(world, 1.0F);
    const float depth = -eye.z;
    if (depth < m_near) {
        return std::nullopt;
    }
    const glm::vec4 clip = m_projection * eye;
    const glm::vec2 ndc = glm::vec2(clip) / clip.w;
    return glm::vec3((ndc.x * 0.5F + 0.5F) * m_size.x, (0.5F - ndc.y * 0.5F) * m_size.y, depth);
}

Ray View::rayThrough(glm::vec2 pixel) const
{
    const glm::vec2 at = pixel + m_corner;
    const glm::vec2 ndc(at.x / m_wholeSize.x * 2.0F - 1.0F, 1.0F - at.y / m_wholeSize.y * 2.0F);
    const float aspect = m_wholeSize.x / m_wholeSize.y;
    if (m_camera.projection == Projection::Perspective) {
        const float tangent = std::tan(m_camera.fovYRadians * 0.5F);
        const glm::vec3 inEye(ndc.x * tangent * aspect, ndc.y * tangent, -1.0F);
        return {m_camera.position, glm::normalize(m_camera.orientation * inEye)};
    }
    const float halfHeight = m_camera.orthographicHeight * 0.5F;
    const glm::vec3 offset =
        m_camera.right() * (ndc.x * halfHeight * aspect) + m_camera.up() * (ndc.y * halfHeight);
    return {m_camera.position + offset - m_camera.forward() * kFar, m_camera.forward()};
}

float View::pixelsPerMetre(float depth) const
{
    if (m_camera.projection == Projection::Orthographic) {
        return m_wholeSize.y / m_camera.orthographicHeight;
    }
    return m_wholeSize.y / (2.0F * std::tan(m_camera.fovYRadians * 0.5F) * std::max(depth, m_near));
}

} // namespace crowd::model
