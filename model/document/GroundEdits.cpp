// SPDX-License-Identifier: MIT
#include "model/document/GroundEdits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/Bounds.h"
#include "model/brush/NeighbourGrid.h"

namespace crowd::model {

namespace {

constexpr float kApart = 0.5F; ///< metres between those who are put down
constexpr int kRings = 8;
constexpr int kSides = 12;

/// The nearest ground to a point where nobody stands yet; where all is full, among the others.
std::optional<glm::vec3> freeGround(const WalkableGround& ground, const NeighbourGrid& people,
                                    const glm::vec3& from)
{
    const auto nearest = ground.nearest(from);
    if (!nearest || people.isFree({*nearest})) {
        return nearest;
    }
    for (int ring = 1; ring <= kRings; ++ring) {
        for (int side = 0; side < kSides; ++side) {
            const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(side) /
                                static_cast<float>(kSides);
            const float radius = kApart * static_cast<float>(ring);
            const glm::vec3 beside =
                *nearest + radius * glm::vec3(std::sin(angle), 0.0F, std::cos(angle));
            if (const auto there = ground.nearest(beside); there && people.isFree({*there})) {
                return there;
            }
        }
    }
    return nearest;
}

} // namespace

std::vector<IndividualId> offGround(const Scene& scene, const WalkableGround& ground,
                                    std::span<const IndividualId> ids)
{
    const auto positions = scene.population.column(columns::position);
    const auto seats = scene.population.column(columns::seat);
    std::vector<IndividualId> off;
    for (const IndividualId id : ids) {
        const std::size_t row = scene.population.rowOf(id);
        if (row != Population::npos && seats[row] == kNoSeat && Bounds::isPlace(positions[row]) &&
            !ground.isWalkable(positions[row])) {
            off.push_back(id);
        }
    }
    return off;
}

int putOnGround(SceneEdit& edit, const WalkableGround& ground, std::span<const IndividualId> ids)
{
    const std::vector<IndividualId> off = offGround(edit.scene(), ground, ids);
    const Population& population = edit.scene().population;
    const auto positions = population.column(columns::position);
    std::vector<GroundDisc> standing;
    standing.reserve(positions.size());
    for (const glm::vec3& at : positions) {
        standing.push_back({at});
    }
    NeighbourGrid people(standing, kApart);
    std::vector<IndividualId> moved;
    std::vector<glm::vec3> places;
    for (const IndividualId id : off) {
        if (const auto place = freeGround(ground, people, positions[population.rowOf(id)])) {
            people.add({*place});
            moved.push_back(id);
            places.push_back(*place);
        }
    }
    if (!moved.empty()) {
        edit.setColumn(columns::position, std::span<const IndividualId>(moved),
                       std::span<const glm::vec3>(places));
    }
    return static_cast<int>(moved.size());
}

} // namespace crowd::model
