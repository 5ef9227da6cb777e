// SPDX-License-Identifier: MIT
#include "widgets/commands/CameraMoves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

namespace crowd::widgets {

using model::Bounds;
using model::Camera;
using model::Projection;
using model::View;

namespace {

constexpr float kSteepest = 1.5690F; // 89.9 degrees
constexpr float kNearest = 0.1F;     // metres
constexpr float kFarthest = 2000.0F;
constexpr float kReach = 5000.0F; // of the camera from the origin
constexpr float kSmallestPicture = 0.05F;
constexpr float kMargin = 1.08F;

float elevationOf(const Camera& camera)
{
    return std::asin(std::clamp(camera.forward().y, -1.0F, 1.0F));
}

/// The part of a pitch that keeps the camera from tipping over.
float boundedPitch(const Camera& camera, float pitch)
{
    const float now = elevationOf(camera);
    const float low = std::min(-kSteepest, now);
    const float high = std::max(kSteepest, now);
    return std::clamp(now + pitch, low, high) - now;
}

glm::quat turnOf(const Camera& camera, float yaw, float pitch)
{
    const glm::quat about = glm::angleAxis(yaw, glm::vec3(0.0F, 1.0F, 0.0F));
    return about * glm::angleAxis(boundedPitch(camera, pitch), camera.right());
}

Camera bounded(Camera camera)
{
    camera.position = glm::clamp(camera.position, glm::vec3(-kReach), glm::vec3(kReach));
    camera.pivotDistance = std::clamp(camera.pivotDistance, kNearest, kFarthest);
    camera.orthographicHeight =
        std::clamp(camera.orthographicHeight, kSmallestPicture, 2.0F * kFarthest);
    return camera;
}

std::array<glm::vec3, 8> cornersOf(const Bounds& box)
{
    std::array<glm::vec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = {(i & 1U) != 0 ? box.high.x : box.low.x,
                      (i & 2U) != 0 ? box.high.y : box.low.y,
                      (i & 4U) != 0 ? box.high.z : box.low.z};
    }
    return corners;
}

} // namespace

float depthOf(const Camera& camera, const glm::vec3& point)
{
    return std::max(glm::dot(point - camera.position, camera.forward()), kNearest);
}

Camera orbited(const Camera& camera, const glm::vec3& around, float yawRadians, float pitchRadians)
{
    const glm::quat turn = turnOf(camera, yawRadians, pitchRadians);
    Camera result = camera;
    result.orientation = glm::normalize(turn * camera.orientation);
    result.position = around + turn * (camera.position - around);
    return bounded(result);
}

Camera turned(const Camera& camera, float yawRadians, float pitchRadians)
{
    return orbited(camera, camera.position, yawRadians, pitchRadians);
}

Camera panned(const Camera& camera, glm::vec2 viewSize, glm::vec2 pixels, float depth)
{
    const float metres = 1.0F / View(camera, viewSize).pixelsPerMetre(depth);
    Camera result = camera;
    result.position += (camera.up() * pixels.y - camera.right() * pixels.x) * metres;
    return bounded(result);
}

Camera dollied(const Camera& camera, const glm::vec3& towards, float factor)
{
    Camera result = camera;
    if (camera.projection == Projection::Orthographic) {
        const float height =
            std::clamp(camera.orthographicHeight * factor, kSmallestPicture, 2.0F * kFarthest);
        const glm::vec3 offset = towards - camera.position;
        const glm::vec3 sideways = offset - camera.forward() * glm::dot(offset, camera.forward());
        result.position += sideways * (1.0F - height / camera.orthographicHeight);
        result.orthographicHeight = height;
        return bounded(result);
    }
    const glm::vec3 way = camera.position - towards;
    const float distance = std::max(glm::length(way), 1e-4F);
    const float wanted = distance * factor;
    // A stop close to the point, never a push away from it while going in.
    const float nearest = std::min(distance, 3.0F * kNearest);
    const float kept = std::clamp(wanted, nearest, std::max(distance, kFarthest));
    result.position = towards + way * (kept / distance);
    result.pivotDistance = camera.pivotDistance * (kept / distance);
    return bounded(result);
}

Camera flown(const Camera& camera, const glm::vec3& metres)
{
    Camera result = camera;
    result.position +=
        camera.right() * metres.x + camera.up() * metres.y + camera.forward() * metres.z;
    return bounded(result);
}

Camera framed(const Camera& camera, glm::vec2 viewSize, const Bounds& box)
{
    if (box.isEmpty()) {
        return camera;
    }
    const float tanY = std::tan(camera.fovYRadians * 0.5F);
    const float tanX = tanY * std::max(viewSize.x, 1.0F) / std::max(viewSize.y, 1.0F);
    const glm::quat toEye = glm::conjugate(camera.orientation);
    float distance = 1.0F;
    float height = 0.5F;
    for (const glm::vec3& corner : cornersOf(box)) {
        const glm::vec3 eye = glm::abs(toEye * (corner - box.center()));
        distance =
            std::max({distance, eye.x / tanX * kMargin + eye.z, eye.y / tanY * kMargin + eye.z});
        height = std::max({height, 2.0F * eye.y * kMargin, 2.0F * eye.x * tanY / tanX * kMargin});
    }
    Camera result = camera;
    result.pivotDistance = std::clamp(distance, kNearest, kFarthest);
    result.orthographicHeight = height;
    result.position = box.center() - camera.forward() * result.pivotDistance;
    return bounded(result);
}

Camera lookingFrom(const Camera& camera, ViewDirection direction)
{
    constexpr float kQuarter = glm::half_pi<float>();
    Camera result = camera;
    switch (direction) {
    case ViewDirection::Top:
        result.orientation = glm::angleAxis(-kQuarter, glm::vec3(1.0F, 0.0F, 0.0F));
        break;
    case ViewDirection::Front:
        result.orientation = glm::quat(1.0F, 0.0F, 0.0F, 0.0F);
        break;
    case ViewDirection::Side:
        result.orientation = glm::angleAxis(kQuarter, glm::vec3(0.0F, 1.0F, 0.0F));
        break;
    }
    result.position = camera.pivot() - result.forward() * camera.pivotDistance;
    return bounded(result);
}

Camera withOtherProjection(const Camera& camera)
{
    const float tangent = std::tan(camera.fovYRadians * 0.5F);
    const glm::vec3 pivot = camera.pivot();
    Camera result = camera;
    if (camera.projection == Projection::Perspective) {
        result.projection = Projection::Orthographic;
        result.orthographicHeight = 2.0F * camera.pivotDistance * tangent;
    } else {
        result.projection = Projection::Perspective;
        result.pivotDistance = camera.orthographicHeight / (2.0F * tangent);
        result.position = pivot - camera.forward() * result.pivotDistance;
    }
    return bounded(result);
}

} // namespace crowd::widgets
