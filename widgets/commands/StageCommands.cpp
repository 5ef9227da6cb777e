// SPDX-License-Identifier: MIT
#include "widgets/commands/StageCommands.h"

#include <vector>

#include <glm/mat4x4.hpp>

namespace crowd::widgets {

using namespace model;

namespace {

/// Ascending indices of those who have a seat on a stage; see Scene::worldSeats.
std::vector<std::size_t> seatedOn(const Population& people, std::uint8_t stage)
{
    constexpr unsigned kStageShift = 24;
    std::vector<std::size_t> seated;
    const auto seats = people.column(columns::seat);
    for (std::size_t i = 0; i < seats.size(); ++i) {
        if (seats[i] != kNoSeat && seats[i] >> kStageShift == stage) {
            seated.push_back(i);
        }
    }
    return seated;
}

} // namespace

void placeStage(SceneEdit& edit, const Scene& scene, const StageEntry& placed)
{
    const StageEntry* found = scene.findStage(placed.id);
    if (found == nullptr) {
        return;
    }
    const glm::mat4 moved = placed.worldFromStage() * glm::inverse(found->worldFromStage());
    const float turned = placed.headingRadians - found->headingRadians;
    std::vector<IndividualId> ids;
    std::vector<glm::vec3> positions;
    std::vector<float> headings;
    const Population& people = scene.population;
    for (const std::size_t i : seatedOn(people, placed.id)) {
        ids.push_back(people.ids()[i]);
        positions.emplace_back(moved * glm::vec4(people.column(columns::position)[i], 1.0F));
        headings.push_back(people.column(columns::heading)[i] + turned);
    }
    edit.changeStage(placed);
    if (!ids.empty()) {
        edit.setColumn<glm::vec3>(columns::position, ids, positions);
        edit.setColumn<float>(columns::heading, ids, headings);
    }
}

} // namespace crowd::widgets
