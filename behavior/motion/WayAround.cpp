// SPDX-License-Identifier: MIT
#include "behavior/motion/WayAround.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtx/norm.hpp>

namespace crowd::behavior {

namespace {

constexpr float kCornerMetres = 0.5F;
constexpr float kPassedCorner = 4.0F; ///< metres: further away nobody has passed it
/// Who does not get nearer to its corner for so long asks for the way again.
constexpr std::uint32_t kAstraySteps = 60;
constexpr std::uint32_t kCheckSteps = 20;

glm::vec2 flat(const glm::vec3& point)
{
    return {point.x, point.z};
}

glm::vec2 unit(const glm::vec2& way)
{
    const float squared = glm::length2(way);
    return squared > 1e-8F ? way / std::sqrt(squared) : glm::vec2(0.0F);
}

} // namespace

void WayAround::forget()
{
    m_corners.clear();
    m_aim = kNoAim;
}

/// Corners that lie behind: it has come to them, or past them further out in the bend.
void WayAround::passCorners(const glm::vec3& at)
{
    while (m_corners.size() > 1) {
        const glm::vec2 corner = flat(m_corners.back());
        const glm::vec2 away = flat(at) - corner;
        const glm::vec2 next = flat(m_corners[m_corners.size() - 2]);
        const glm::vec2 through = unit(corner - m_before) + unit(next - corner);
        const bool isPast =
            glm::dot(away, through) > 0.0F && glm::length2(away) < kPassedCorner * kPassedCorner;
        if (glm::length2(away) >= kCornerMetres * kCornerMetres && !isPast) {
            return;
        }
        m_before = corner;
        m_corners.pop_back();
        m_stepsAstray = 0;
    }
}

/// Others may have pushed it off its way, so far that something is between, or to where the next
/// corner is on another level.
void WayAround::check(const WalkSurface& surface, const glm::vec3& at)
{
    if (m_stepsToCheck > 0) {
        --m_stepsToCheck;
        return;
    }
    m_stepsToCheck = kCheckSteps;
    if (!m_corners.empty() && !surface.isStraight(at, m_corners.back()).value_or(true)) {
        m_aim = kNoAim;
    }
}

glm::vec2 WayAround::towards(const WalkSurface& surface, const Body& body, float height,
                             const glm::vec3& aim, const Lane& lane)
{
    const glm::vec3 at(body.x, height, body.z);
    passCorners(at);
    check(surface, at);
    if (m_aim != flat(aim) || m_stepsAstray > kAstraySteps) {
        m_corners = surface.way(at, aim, lane);
        std::ranges::reverse(m_corners);
        m_aim = flat(aim);
        m_before = flat(at);
        m_stepsAstray = 0;
        passCorners(at);
    }
    const glm::vec2 way = (m_corners.empty() ? flat(aim) : flat(m_corners.back())) - flat(at);
    const float closing = way.x * body.velocityX + way.y * body.velocityZ;
    m_stepsAstray = closing > 0.0F ? 0 : m_stepsAstray + 1;
    return way;
}

bool WayAround::endsShort(const glm::vec2& aim, const glm::vec2& from, float metres) const
{
    const glm::vec2 end = m_corners.size() == 1 ? flat(m_corners.front()) : m_aim;
    return m_aim == aim && end != aim && glm::length2(end - from) < metres * metres;
}

} // namespace crowd::behavior
