// SPDX-License-Identifier: MIT
#include "model/brush/SeatMap.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace crowd::model {

namespace {

constexpr float kLapAboveSeat = 0.15F;
constexpr float kHeadAboveSeat = 0.8F;
constexpr double kSeatReachMetres = 0.5;
constexpr double kLeastReachPixels = 12.0;

std::vector<SeatId> takenSeats(const Population& people)
{
    std::vector<SeatId> taken;
    for (const SeatId seat : people.column(columns::seat)) {
        if (seat != kNoSeat) {
            taken.push_back(seat);
        }
    }
    std::ranges::sort(taken);
    return taken;
}

glm::vec3 above(const Seat& seat, float metres)
{
    return seat.position + glm::vec3(0.0F, seat.height + metres, 0.0F);
}

} // namespace

SeatMap::SeatMap(const Scene& scene, const View& view, const StageRays& stage,
                 const SeatGridSettings& settings, bool through)
    : m_view(view), m_stage(stage), m_through(through)
{
    const std::vector<SeatId> taken = takenSeats(scene.population);
    for (const WorldSeat& seat : scene.worldSeats()) {
        m_hasSeats = true;
        const auto foot = view.project(seat.seat.position);
        const auto mark = view.project(above(seat.seat, 0.0F));
        const auto lap = view.project(above(seat.seat, kLapAboveSeat));
        if (!foot || !mark || !lap || !settings.allows(seat.seat.rank, seat.seat.wedge)) {
            continue;
        }
        Place place;
        place.seat = seat;
        place.foot = {foot->x, foot->y};
        place.mark = {mark->x, mark->y};
        place.lap = {lap->x, lap->y};
        place.reach = std::max(kLeastReachPixels, kSeatReachMetres * view.pixelsPerMetre(foot->z));
        place.isFree = !std::ranges::binary_search(taken, seat.id);
        m_places.push_back(place);
    }
}

bool SeatMap::isSeen(Place& place) const
{
    if (m_through) {
        return true;
    }
    if (place.seen == Place::Seen::Unknown) {
        const auto sees = [&](const glm::vec3& point) {
            const auto pixel = m_view.project(point);
            return pixel && !m_stage.isBlocked(m_view.rayThrough(glm::vec2(*pixel)).origin, point);
        };
        place.seen = sees(above(place.seat.seat, kHeadAboveSeat)) ||
                             sees(above(place.seat.seat, kLapAboveSeat))
                         ? Place::Seen::Yes
                         : Place::Seen::No;
    }
    return place.seen == Place::Seen::Yes;
}

std::vector<WorldSeat> SeatMap::freeIn(const ScreenArea& area)
{
    std::vector<WorldSeat> seats;
    for (Place& place : m_places) {
        if (place.isFree && area.contains(place.mark) && isSeen(place)) {
            seats.push_back(place.seat);
        }
    }
    return seats;
}

std::optional<WorldSeat> SeatMap::nearestFree(glm::dvec2 pixel,
                                              const std::optional<ScreenArea>& area)
{
    const Place* nearest = nullptr;
    double nearestDistance = 0.0;
    for (Place& place : m_places) {
        const double distance =
            std::min(glm::distance(pixel, place.foot), glm::distance(pixel, place.lap));
        const bool isInReach = area ? area->contains(place.mark) : distance <= place.reach;
        if (place.isFree && isInReach && (nearest == nullptr || distance < nearestDistance) &&
            isSeen(place)) {
            nearest = &place;
            nearestDistance = distance;
        }
    }
    return nearest != nullptr ? std::optional(nearest->seat) : std::nullopt;
}

SeatMap::Place* SeatMap::find(SeatId seat)
{
    const auto found = std::ranges::lower_bound(m_places, seat, {},
                                                [](const Place& place) { return place.seat.id; });
    return found != m_places.end() && found->seat.id == seat ? &*found : nullptr;
}

void SeatMap::take(SeatId seat)
{
    if (Place* place = find(seat)) {
        place->isFree = false;
    }
}

void SeatMap::release(SeatId seat)
{
    if (Place* place = find(seat)) {
        place->isFree = true;
    }
}

} // namespace crowd::model
