// SPDX-License-Identifier: MIT
#include "model/scene/Scene.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

namespace crowd::model {

namespace {

template<class Entries, class Id>
auto findById(Entries& entries, Id id) -> decltype(entries.data())
{
    const auto found =
        std::ranges::find_if(entries, [id](const auto& entry) { return entry.id == id; });
    return found == entries.end() ? nullptr : &*found;
}

constexpr float kEmptyGroundHalfSize = 10.0F;

} // namespace

glm::mat4 StageEntry::worldFromStage() const
{
    glm::mat4 matrix = glm::translate(glm::mat4(1.0F), position);
    matrix = glm::rotate(matrix, headingRadians, glm::vec3(0.0F, 1.0F, 0.0F));
    return glm::scale(matrix, glm::vec3(scale));
}

const TemplateEntry* Scene::findTemplate(TemplateId id) const
{
    return findById(templates, id);
}

TemplateEntry* Scene::findTemplate(TemplateId id)
{
    return findById(templates, id);
}

const StageEntry* Scene::findStage(std::uint8_t id) const
{
    return findById(stages, id);
}

const Place* Scene::findPlace(PlaceId id) const
{
    return findById(places, id);
}

const Path* Scene::findPath(PathId id) const
{
    return findById(paths, id);
}

const Group* Scene::findGroup(GroupId id) const
{
    return findById(groups, id);
}

bool Scene::isTouchable(std::size_t row) const
{
    const Group* group = findGroup(population.column(columns::group)[row]);
    return group == nullptr || !(group->isHidden || group->isLocked);
}

std::vector<GroupId> Scene::parties() const
{
    const auto column = population.column(columns::group);
    std::vector<GroupId> parties(column.begin(), column.end());
    if (!groups.empty()) {
        for (GroupId& party : parties) {
            const Group* group = findGroup(party);
            party = group == nullptr || group->isParty ? party : 0;
        }
    }
    return parties;
}

bool Scene::hasBehaviour() const
{
    const auto followed = population.column(columns::path);
    return std::ranges::any_of(rules, &Rule::isEnabled) ||
           std::ranges::any_of(followed, [](PathId path) { return path != 0; });
}

std::vector<WorldSeat> Scene::worldSeats() const
{
    std::vector<WorldSeat> seats;
    for (const StageEntry& entry : stages) {
        if (!entry.asset) {
            continue;
        }
        const glm::mat4 matrix = entry.worldFromStage();
        for (std::size_t i = 0; i < entry.asset->seats.size(); ++i) {
            Seat seat = entry.asset->seats[i];
            seat.position = glm::vec3(matrix * glm::vec4(seat.position, 1.0F));
            seat.headingRadians += entry.headingRadians;
            seat.height *= entry.scale;
            seats.push_back({static_cast<SeatId>(entry.id) << 24U | static_cast<SeatId>(i), seat});
        }
    }
    return seats;
}

Bounds Scene::worldBounds() const
{
    Bounds bounds;
    for (const StageEntry& entry : stages) {
        if (!entry.asset || entry.asset->bounds.isEmpty()) {
            continue;
        }
        const glm::mat4 matrix = entry.worldFromStage();
        for (int corner = 0; corner < 8; ++corner) {
            const Bounds& box = entry.asset->bounds;
            const glm::vec3 point((corner & 1) != 0 ? box.high.x : box.low.x,
                                  (corner & 2) != 0 ? box.high.y : box.low.y,
                                  (corner & 4) != 0 ? box.high.z : box.low.z);
            bounds.add(glm::vec3(matrix * glm::vec4(point, 1.0F)));
        }
    }
    for (const glm::vec3& position : population.column(columns::position)) {
        bounds.add(position);
        bounds.add(position + glm::vec3(0.0F, 2.0F, 0.0F));
    }
    if (bounds.isEmpty()) {
        bounds.add(glm::vec3(-kEmptyGroundHalfSize, 0.0F, -kEmptyGroundHalfSize));
        bounds.add(glm::vec3(kEmptyGroundHalfSize, 2.0F, kEmptyGroundHalfSize));
    }
    return bounds;
}

glm::mat4 individualMatrix(const glm::vec3& position, float headingRadians, float height,
                           float girth)
{
    glm::mat4 matrix = glm::translate(glm::mat4(1.0F), position);
    matrix = glm::rotate(matrix, headingRadians, glm::vec3(0.0F, 1.0F, 0.0F));
    return glm::scale(matrix, glm::vec3(girth, height, girth));
}

} // namespace crowd::model
