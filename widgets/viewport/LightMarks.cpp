// SPDX-License-Identifier: MIT
#include "widgets/viewport/LightMarks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "model/scene/LightAim.h"

namespace crowd::widgets {

namespace {

constexpr float kLampShare = 0.018F; ///< its radius, of the distance from the camera
constexpr int kLampSides = 12;
constexpr int kConeSides = 32;
constexpr int kConeEdges = 4;
constexpr float kOthersAlpha = 0.55F;
constexpr float kRimShare = 1.25F; ///< of the lamp's radius
constexpr glm::vec3 kRim(0.03F);   ///< on a bright sky the lamp is seen by it

/// Light enough to be seen on anything, in the light's hue.
glm::vec4 markColor(const model::Light& light, bool isChosen)
{
    const glm::vec3 hue =
        glm::vec3(light.color[0], light.color[1], light.color[2]) * (1.0F / 255.0F);
    const glm::vec3 shown = light.isOn ? glm::mix(hue, glm::vec3(1.0F), 0.35F) : glm::vec3(0.55F);
    return {shown, isChosen ? 0.95F : kOthersAlpha};
}

} // namespace

void LightMarks::addCross(const glm::vec3& at, float metres, const glm::vec4& color)
{
    for (const glm::vec3& axis : {glm::vec3(metres, 0.0F, 0.0F), glm::vec3(0.0F, metres, 0.0F),
                                  glm::vec3(0.0F, 0.0F, metres)}) {
        m_lines.push_back({at - axis, at + axis, color});
    }
}

/// A disc that faces the camera, of the same size from anywhere.
void LightMarks::addLamp(const model::Light& light, const glm::vec4& color,
                         const model::Camera& camera)
{
    const float away = camera.projection == model::Projection::Perspective
                           ? glm::distance(camera.position, light.position)
                           : camera.orthographicHeight;
    const float radius = kLampShare * away;
    const auto at = [&](int side, float share = 1.0F) {
        const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(side) /
                            static_cast<float>(kLampSides);
        return light.position +
               share * radius * (std::sin(angle) * camera.right() + std::cos(angle) * camera.up());
    };
    const glm::vec4 rim(kRim, color.a);
    for (int side = 0; side < kLampSides; ++side) {
        m_lines.push_back({at(side, kRimShare), at(side + 1, kRimShare), rim, 4.0F, 4.0F});
    }
    for (int side = 0; side < kLampSides; ++side) {
        m_lines.push_back({at(side), at(side + 1), color, 3.0F, 3.0F});
        m_lines.push_back({at(side), light.position, color, 3.0F, 3.0F});
    }
}

void LightMarks::addCone(const model::Light& light, const glm::vec3& target, const glm::vec4& color)
{
    const glm::vec3 way = target - light.position;
    const float length = glm::length(way);
    if (length < 0.01F) {
        return;
    }
    const glm::vec3 axis = way / length;
    const glm::vec3 helper =
        std::abs(axis.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(1.0F, 0.0F, 0.0F);
    const glm::vec3 side = glm::normalize(glm::cross(axis, helper));
    const glm::vec3 up = glm::cross(side, axis);
    const float half = std::min(light.coneRadians * 0.5F, 1.45F); // wider ones have no such circle
    const float radius = length * std::tan(half);
    const auto at = [&](float share) {
        const float angle = 2.0F * std::numbers::pi_v<float> * share;
        return target + radius * (std::sin(angle) * side + std::cos(angle) * up);
    };
    for (int i = 0; i < kConeSides; ++i) {
        m_lines.push_back({at(static_cast<float>(i) / kConeSides),
                           at(static_cast<float>(i + 1) / kConeSides), color, 1.5F, 1.5F});
    }
    for (int i = 0; i < kConeEdges; ++i) {
        m_lines.push_back(
            {light.position, at(static_cast<float>(i) / kConeEdges), color, 1.0F, 1.0F});
    }
}

void LightMarks::make(const EditorState& state, const model::CrowdFrame& frame)
{
    m_lines.clear();
    if (state.chosenLight() == 0) {
        return;
    }
    for (const model::Light& light : state.scene().lights) {
        const bool isChosen = light.id == state.chosenLight();
        const glm::vec4 color = markColor(light, isChosen);
        addLamp(light, color, state.camera());
        const auto target = aimedAt(light, &frame);
        if (isChosen && isAimed(light) && target) {
            addCone(light, *target, color);
            const float metres = 0.02F * glm::distance(state.camera().position, *target);
            addCross(*target, metres, color);
            addCross(coneEdge(light, *target, state.camera().right()), 0.6F * metres, color);
        }
    }
}

} // namespace crowd::widgets
