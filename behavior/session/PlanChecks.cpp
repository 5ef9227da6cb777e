// SPDX-License-Identifier: MIT
#include "behavior/session/PlanChecks.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/scene/PlaceShape.h"

namespace crowd::behavior {

namespace {

constexpr float kSearchMetres = 30.0F;    ///< for ground near a place
constexpr float kLeastReach = 0.5F;       ///< metres around a place
constexpr float kDetourShare = 1.1F;      ///< of the straight way, from which it is one
constexpr float kDetourMetres = 1.0F;     ///< longer than the straight way
constexpr float kCrowdedPerMetre2 = 5.0F; ///< people; more do not fit
constexpr std::uint32_t kAFew = 10;

float lengthOf(const std::vector<glm::vec2>& way, glm::vec2 at)
{
    float length = 0.0F;
    for (const glm::vec2& corner : way) {
        length += glm::distance(at, corner);
        at = corner;
    }
    return length;
}

void checkLeg(const model::Path& path, const model::Place& from, const model::Place& to,
              const WalkSurface& surface, std::vector<Problem>& problems)
{
    const std::vector<glm::vec2> way = surface.way(from.position, to.position);
    if (way.empty()) {
        return; // it is the place that is somewhere else
    }
    const glm::vec2 start(from.position.x, from.position.z);
    const glm::vec2 end(to.position.x, to.position.z);
    const float straight = glm::distance(start, end);
    const float length = lengthOf(way, start);
    if (glm::distance(way.back(), end) > std::max(to.radius, kLeastReach)) {
        problems.push_back(
            {{QT_TRANSLATE_NOOP(
                  "Messages",
                  "Path \"%1\": between \"%2\" and \"%3\" no way leads; characters go as near as "
                  "they can. Move one of them, or lead the path around what is between."),
              path.name, from.name, to.name},
             0,
             0,
             path.id});
    } else if (way.size() > 1 && length > straight * kDetourShare &&
               length > straight + kDetourMetres) {
        problems.push_back(
            {{QT_TRANSLATE_NOOP("Messages",
                                "Path \"%1\": between \"%2\" and \"%3\" something is in the way; "
                                "characters go around it. Add places where they should go."),
              path.name, from.name, to.name},
             0,
             0,
             path.id});
    }
}

} // namespace

std::vector<Problem> problemsOfPlaces(std::span<const model::Place> places,
                                      const WalkSurface& surface)
{
    std::vector<Problem> problems;
    for (const model::Place& place : places) {
        const bool isOn = place.role != model::PlaceRole::Spot ||
                          surface.reaches(place.position, std::max(place.radius, kLeastReach));
        const glm::vec3 below(place.position.x, 0.0F, place.position.z);
        if (!isOn && (surface.reaches(place.position, kSearchMetres) ||
                      surface.reaches(below, kSearchMetres))) {
            problems.push_back(
                {{QT_TRANSLATE_NOOP("Messages", "Place \"%1\" is not on ground that characters can "
                                                "walk on; they go as near as they can. Move it."),
                  place.name},
                 0,
                 place.id});
        }
    }
    return problems;
}

std::vector<Problem> problemsOfPaths(std::span<const model::Path> paths,
                                     std::span<const model::Place> places,
                                     const WalkSurface& surface)
{
    std::vector<Problem> problems;
    const auto placeOf = [places](model::PlaceId id) {
        const auto found = std::ranges::find(places, id, &model::Place::id);
        return found == places.end() ? nullptr : &*found;
    };
    for (const model::Path& path : paths) {
        const bool isRound = path.kind == model::PathKind::Cyclic;
        for (std::size_t i = 0; i + (isRound ? 0 : 1) < path.places.size(); ++i) {
            const model::Place* from = placeOf(path.places[i]);
            const model::Place* to = placeOf(path.places[(i + 1) % path.places.size()]);
            if (from != nullptr && to != nullptr && from != to) {
                checkLeg(path, *from, *to, surface, problems);
            }
        }
    }
    return problems;
}

std::vector<Problem> problemsOfPeople(std::vector<model::IndividualId> offSurface)
{
    if (offSurface.empty()) {
        return {};
    }
    Problem problem;
    problem.text = {
        offSurface.size() == 1
            ? QT_TRANSLATE_NOOP("Messages",
                                "%1 character who should walk stand where no way leads to or from: "
                                "on roofs or trees, in a basin, in the air. Put them on the "
                                "nearest ground (Edit, Put on the Ground).")
            : QT_TRANSLATE_NOOP("Messages",
                                "%1 characters who should walk stand where no way leads to or "
                                "from: on roofs or trees, in a basin, in the air. Put them on the "
                                "nearest ground (Edit, Put on the Ground)."),
        offSurface.size()};
    problem.people = std::move(offSurface);
    return {problem};
}

std::vector<Problem> problemsOfCrowding(const GuestCounts& guests,
                                        std::span<const model::Place> places,
                                        std::span<const Problem> known)
{
    std::vector<Problem> problems;
    for (const auto& [id, count] : guests) {
        const auto place = std::ranges::find(places, id, &model::Place::id);
        if (place == places.end() || place->role == model::PlaceRole::Exit) {
            continue;
        }
        const float area = 3.14159265F * place->radius * place->radius;
        const bool isKnown = std::ranges::any_of(known, [id = id](const Problem& problem) {
            return problem.place == id &&
                   problem.text.english().find("characters want") != std::string::npos;
        });
        if (!isKnown && static_cast<float>(count) > area * kCrowdedPerMetre2 + kAFew) {
            problems.push_back(
                {{QT_TRANSLATE_NOOP(
                      "Messages", "Place \"%1\": %2 characters want to stand there; there is room "
                                  "for %3. Make it larger, or send them to several places."),
                  place->name, count, model::roomOf(*place)},
                 0,
                 id});
        }
    }
    return problems;
}

} // namespace crowd::behavior
