// SPDX-License-Identifier: MIT
#include "behavior/motion/PathRoutes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/gtx/norm.hpp>

#include "model/base/Bounds.h"
#include "model/base/Segment.h"

namespace crowd::behavior {

namespace {

constexpr float kWidestPlace = 1e4F; ///< metres

} // namespace

glm::vec2 Route::backToLeg(std::uint32_t stop, const glm::vec2& at) const
{
    const bool isClosed = kind == model::PathKind::Cyclic;
    const std::size_t before = stop > 0 ? stop - 1 : isClosed ? stops.size() - 1 : stop;
    const RouteStop& from = stops[before];
    const RouteStop& to = stops[stop];
    const float share =
        model::nearestShare({at.x, 0.0F, at.y}, {from.position.x, 0.0F, from.position.y},
                            {to.position.x, 0.0F, to.position.y});
    const glm::vec2 away = glm::mix(from.position, to.position, share) - at;
    const float distance = glm::length(away);
    const float beside = distance - glm::mix(from.radius, to.radius, share);
    return beside > 0.0F ? away * (beside / distance) : glm::vec2(0.0F);
}

std::uint32_t Route::nextStop(const glm::vec3& from) const
{
    const auto count = static_cast<std::uint32_t>(stops.size());
    const std::uint32_t legs = kind == model::PathKind::Cyclic && count > 2 ? count : count - 1;
    const auto point = [&](std::uint32_t stop) {
        const RouteStop& at = stops[stop % count];
        return glm::vec3(at.position.x, at.height, at.position.y);
    };
    std::uint32_t next = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::uint32_t leg = 0; leg < legs; ++leg) {
        const glm::vec3 begin = point(leg);
        const glm::vec3 end = point(leg + 1);
        const float share = model::nearestShare(from, begin, end);
        const float distance2 = glm::distance2(from, glm::mix(begin, end, share));
        if (distance2 < least) {
            least = distance2;
            next = share > 0.0F ? (leg + 1) % count : leg;
        }
    }
    return next;
}

Route PathRoutes::routeOf(const model::Path& path, std::span<const model::Place> places,
                          std::vector<Problem>& problems)
{
    Route route{path.id, path.kind, {}};
    for (const model::PlaceId id : path.places) {
        const auto place = std::ranges::find(places, id, &model::Place::id);
        if (place == places.end()) {
            problems.push_back(
                {{QT_TRANSLATE_NOOP("Messages", "Path \"%1\" names a place that is not there any "
                                                "more; characters pass it over."),
                  path.name},
                 0,
                 0,
                 path.id});
            continue;
        }
        if (!model::Bounds::isPlace(place->position) || !std::isfinite(place->radius)) {
            problems.push_back(
                {{QT_TRANSLATE_NOOP("Messages", "Place \"%1\" has no position or size; characters "
                                                "pass it over. Give it numbers."),
                  place->name},
                 0,
                 place->id,
                 path.id});
            continue;
        }
        RouteStop stop{id,
                       {place->position.x, place->position.z},
                       place->position.y,
                       std::clamp(place->radius, 0.0F, kWidestPlace)};
        for (const model::PathBranch& branch : path.branches) {
            if (branch.place == id) {
                stop.branches.push_back({branch.path, std::max(branch.weight, 0.0F)});
            }
        }
        route.stops.push_back(std::move(stop));
    }
    return route;
}

std::vector<Problem> PathRoutes::set(std::span<const model::Place> places,
                                     std::span<const model::Path> paths)
{
    std::vector<Problem> problems;
    m_routes.clear();
    for (const model::Path& path : paths) {
        Route route = routeOf(path, places, problems);
        if (route.stops.empty()) {
            problems.push_back(
                {{QT_TRANSLATE_NOOP("Messages",
                                    "Path \"%1\" has no places: nobody can walk it. Add some."),
                  path.name},
                 0,
                 0,
                 path.id});
        } else {
            m_routes.push_back(std::move(route));
        }
    }
    return problems;
}

std::uint32_t PathRoutes::indexOf(model::PathId path) const
{
    const auto route = std::ranges::find(m_routes, path, &Route::id);
    return route == m_routes.end() ? kNone : static_cast<std::uint32_t>(route - m_routes.begin());
}

} // namespace crowd::behavior
