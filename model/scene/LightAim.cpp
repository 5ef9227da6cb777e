// SPDX-License-Identifier: MIT
#include "model/scene/LightAim.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/base/Bounds.h"

namespace crowd::model {

namespace {

constexpr float kChestMetres = 1.2F; ///< above the ground they stand on

std::optional<glm::vec3> chestOf(const Population& people, IndividualId id)
{
    const std::size_t row = people.rowOf(id);
    if (row == Population::npos) {
        return std::nullopt;
    }
    const glm::vec3 at = people.column(columns::position)[row];
    return Bounds::isPlace(at) ? std::optional(at + glm::vec3(0.0F, kChestMetres, 0.0F))
                               : std::nullopt;
}

std::optional<glm::vec3> middleOf(const Population& people, GroupId group)
{
    const auto groups = people.column(columns::group);
    const auto positions = people.column(columns::position);
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (std::size_t row = 0; row < groups.size(); ++row) {
        if (groups[row] == group && Bounds::isPlace(positions[row])) {
            sum += glm::dvec3(positions[row]);
            count += 1.0;
        }
    }
    if (count == 0.0) {
        return std::nullopt;
    }
    return glm::vec3(sum / count) + glm::vec3(0.0F, kChestMetres, 0.0F);
}

} // namespace

std::optional<glm::vec3> aimedAt(const Light& light, const CrowdFrame* frame)
{
    const bool isChosen = (light.aim == LightAim::Person && light.person != 0) ||
                          (light.aim == LightAim::Group && light.group != 0);
    if (!isAimed(light) || !isChosen) {
        return light.target; // also until it is said with whom it goes
    }
    if (frame == nullptr) {
        return std::nullopt;
    }
    return light.aim == LightAim::Person ? chestOf(frame->population, light.person)
                                         : middleOf(frame->population, light.group);
}

glm::vec3 coneEdge(const Light& light, const glm::vec3& target, const glm::vec3& direction)
{
    constexpr float kWidestHalf = 1.45F; // radians; wider ones have no such circle
    const glm::vec3 way = target - light.position;
    const float length = std::max(glm::length(way), 1e-3F);
    const glm::vec3 axis = length > 1e-3F ? way / length : glm::vec3(0.0F, -1.0F, 0.0F);
    glm::vec3 aside = direction - axis * glm::dot(direction, axis);
    if (glm::length(aside) < 1e-3F) { // one looks along it
        const glm::vec3 helper =
            std::abs(axis.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(1.0F, 0.0F, 0.0F);
        aside = glm::cross(axis, helper);
    }
    const float half = std::min(light.coneRadians * 0.5F, kWidestHalf);
    return target + glm::normalize(aside) * (length * std::tan(half));
}

} // namespace crowd::model
