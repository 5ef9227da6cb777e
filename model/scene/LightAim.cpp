// SPDX-License-Identifier: MIT
#include "model/scene/LightAim.h"

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

} // namespace crowd::model
