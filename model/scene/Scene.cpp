// SPDX-License-Identifier: MIT
#include "model/scene/Scene.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

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

LookId Scene::freeLookId() const
{
    LookId last = 0;
    for (const LookPreset& each : looks) {
        last = std::max(last, each.id);
    }
    for (const NamedCamera& each : cameras) {
        last = std::max(last, each.look);
    }
    const bool isFull = looks.size() >= kMostLooks || last == std::numeric_limits<LookId>::max();
    return isFull ? 0 : last + 1;
}

bool Scene::isTouchable(std::size_t row) const
{
    const Group* group = findGroup(population.column(columns::group)[row]);
    return group == nullptr || !(group->isHidden || group->isLocked);
}

namespace {

/// Ids of the kinds of which `isMeant` is true; nothing where nobody is related so.
template<class IsMeant>
std::vector<char> kindsThat(const Scene& scene, const IsMeant& isMeant)
{
    std::vector<char> kinds(kMostRelationKinds + 1, 0);
    bool isAny = false;
    for (const RelationKind& kind : scene.relationKinds) {
        kinds[kind.id] = isMeant(kind) ? 1 : 0;
        isAny = isAny || kinds[kind.id] != 0;
    }
    return isAny && !scene.relations.isEmpty() ? kinds : std::vector<char>();
}

std::size_t rootOf(std::vector<std::size_t>& roots, std::size_t row)
{
    while (roots[row] != row) {
        roots[row] = roots[roots[row]];
        row = roots[row];
    }
    return row;
}

/// Whoever is related by a kind that walks together is of one party, however many that are.
void joinRelated(const Scene& scene, std::vector<GroupId>& parties)
{
    const std::vector<char> kinds = kindsThat(
        scene, [](const RelationKind& kind) { return kind.walk == RelationWalk::Together; });
    if (kinds.empty()) {
        return;
    }
    const Population& people = scene.population;
    std::vector<std::size_t> roots(people.size());
    std::iota(roots.begin(), roots.end(), std::size_t{0});
    std::vector<char> isRelated(people.size(), 0);
    for (std::size_t row = 0; row < people.size(); ++row) {
        for (const RelationLink& link : scene.relations.of(people.ids()[row])) {
            const std::size_t other = people.rowOf(link.other);
            if (kinds[link.kind] != 0 && link.isOut && other != Population::npos) {
                const std::size_t a = rootOf(roots, row);
                const std::size_t b = rootOf(roots, other);
                roots[std::max(a, b)] = std::min(a, b);
                isRelated[row] = isRelated[other] = 1;
            }
        }
    }
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (isRelated[row] != 0) {
            parties[row] = kRelatedParty + static_cast<GroupId>(rootOf(roots, row));
        }
    }
}

bool doRelatedAct(const Scene& scene)
{
    const std::vector<char> kinds = kindsThat(scene, std::mem_fn(&RelationKind::isActive));
    const auto isMeant = [&](IndividualId id) {
        return std::ranges::any_of(scene.relations.of(id), [&kinds](const RelationLink& link) {
            return kinds[link.kind] != 0;
        });
    };
    return !kinds.empty() && std::ranges::any_of(scene.population.ids(), isMeant);
}

} // namespace

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
    joinRelated(*this, parties);
    return parties;
}

bool Scene::hasBehaviour() const
{
    const auto followed = population.column(columns::path);
    return std::ranges::any_of(rules, &Rule::isEnabled) || doesAnything(timeline) ||
           doRelatedAct(*this) ||
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
