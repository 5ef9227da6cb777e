// SPDX-License-Identifier: MIT
#include "model/brush/Operator.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "model/base/Random.h"

namespace crowd::model {

namespace {

/// Where a ray meets the horizontal plane at a height.
std::optional<glm::vec3> onPlane(const Ray& ray, float height)
{
    const float distance = (height - ray.origin.y) / ray.direction.y;
    if (!std::isfinite(distance) || distance <= 0.0F) {
        return std::nullopt;
    }
    return ray.origin + ray.direction * distance;
}

std::optional<float> turned(std::optional<float> heading, float radians)
{
    return heading ? std::optional(wrappedAngle(*heading + radians)) : std::nullopt;
}

std::optional<float> headingOfWay(const glm::vec3& way)
{
    if (way.x * way.x + way.z * way.z < 1.0e-12F) {
        return std::nullopt;
    }
    return std::atan2(way.x, way.z);
}

} // namespace

double randomUnit(std::uint64_t key, DrawPurpose purpose, std::uint64_t extra)
{
    return unitDouble(hashKeys(key, static_cast<std::uint64_t>(purpose), extra));
}

std::optional<float> headingOfLine(const View& view, const StageRays& stage, const StrokeLine& line)
{
    const Ray toEnd = view.rayThrough(glm::vec2(line.to));
    const auto surface = stage.hit(toEnd);
    if (!surface || line.from == line.to) {
        return std::nullopt;
    }
    const auto start = onPlane(view.rayThrough(glm::vec2(line.from)), surface->point.y);
    return start ? headingOfWay(surface->point - *start) : std::nullopt;
}

float wrappedAngle(float radians)
{
    return std::remainder(radians, 2.0F * std::numbers::pi_v<float>);
}

std::optional<float> headingFor(const HeadingSettings& settings, const View& view,
                                const glm::vec3& position, std::optional<float> strokeHeading,
                                double u)
{
    switch (settings.mode) {
    case HeadingMode::Direction:
        return wrappedAngle(settings.headingRadians);
    case HeadingMode::Random:
        return wrappedAngle(settings.headingRadians +
                            static_cast<float>(2.0 * u - 1.0) * settings.spreadRadians);
    case HeadingMode::AlongStroke:
        return turned(strokeHeading, settings.turnRadians);
    case HeadingMode::TowardsPoint:
        return turned(headingOfWay(settings.towardsPoint - position), settings.turnRadians);
    case HeadingMode::TowardsViewer:
        return turned(view.camera().projection == Projection::Perspective
                          ? headingOfWay(view.camera().position - position)
                          : headingOfWay(-view.camera().forward()),
                      settings.turnRadians);
    }
    return std::nullopt;
}

} // namespace crowd::model
