// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/brush/BrushSettings.h"
#include "model/scene/Scene.h"
#include "model/scene/SceneChange.h"
#include "render/RenderInput.h"

namespace crowd::widgets {

/// The seats of the scene in the world frame, and discs on those that are free. Computed again only
/// after a change that concerns them.
class SeatMarkers
{
public:
    void follow(const model::SceneChange& change);
    /// Ascending by id.
    [[nodiscard]] std::span<const model::WorldSeat> seats(const model::Scene& scene);
    /// Grows when seats() gives others.
    [[nodiscard]] std::uint64_t version() const { return m_version; }
    /// Discs on those that the seat grid allows.
    [[nodiscard]] std::span<const render::Marker> freeSeats(const model::Scene& scene,
                                                            const model::SeatGridSettings& grid);

private:
    std::vector<model::WorldSeat> m_seats;
    std::vector<render::Marker> m_markers;
    std::uint64_t m_version = 0;
    model::SeatGridSettings m_grid; ///< of the markers
    bool m_areSeatsStale = true;
    bool m_areMarkersStale = true;
};

} // namespace crowd::widgets
