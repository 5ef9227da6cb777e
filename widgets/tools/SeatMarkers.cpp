// SPDX-License-Identifier: MIT
#include "widgets/tools/SeatMarkers.h"

#include <algorithm>

namespace crowd::widgets {

using namespace model;

namespace {

constexpr float kRadius = 0.11F; ///< metres
const glm::vec4 kColor(0.30F, 0.95F, 0.55F, 0.85F);

} // namespace

void SeatMarkers::follow(const SceneChange& change)
{
    if (std::holds_alternative<SceneReplaced>(change) ||
        std::holds_alternative<StagesChanged>(change)) {
        m_areSeatsStale = true;
        m_areMarkersStale = true;
    } else if (const auto* columns = std::get_if<ColumnsChanged>(&change)) {
        m_areMarkersStale |= columns->columns.contains(ColumnId::Seat);
    } else if (std::holds_alternative<IndividualsAdded>(change) ||
               std::holds_alternative<IndividualsRemoved>(change)) {
        m_areMarkersStale = true;
    }
}

std::span<const WorldSeat> SeatMarkers::seats(const Scene& scene)
{
    if (m_areSeatsStale) {
        m_seats = scene.worldSeats();
        m_areSeatsStale = false;
        ++m_version;
    }
    return m_seats;
}

std::span<const render::Marker> SeatMarkers::freeSeats(const Scene& scene,
                                                       const SeatGridSettings& grid)
{
    const std::span<const WorldSeat> all = seats(scene);
    if (!m_areMarkersStale && grid == m_grid) {
        return m_markers;
    }
    m_grid = grid;
    const std::span<const SeatId> column = scene.population.column(columns::seat);
    std::vector<SeatId> taken(column.begin(), column.end());
    std::sort(taken.begin(), taken.end());
    m_markers.clear();
    for (const WorldSeat& seat : all) {
        const bool isFree = !std::binary_search(taken.begin(), taken.end(), seat.id);
        if (isFree && grid.allows(seat.seat.rank, seat.seat.wedge)) {
            const glm::vec3 up(0.0F, seat.seat.height + 0.02F, 0.0F);
            m_markers.push_back({seat.seat.position + up, kRadius, kColor});
        }
    }
    m_areMarkersStale = false;
    return m_markers;
}

} // namespace crowd::widgets
