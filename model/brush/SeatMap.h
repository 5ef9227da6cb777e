// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "model/brush/BrushSettings.h"
#include "model/pick/ScreenArea.h"
#include "model/pick/StageRays.h"
#include "model/scene/Scene.h"
#include "model/view/View.h"

namespace crowd::model {

/// The seats of a scene as a stroke sees them: those of the chosen ranks and wedges that are on
/// screen and that nobody's row names. A seat hidden by the stage (both where a sitting person's
/// lap and where the head would be) does not count unless `through`.
class SeatMap
{
public:
    SeatMap(const Scene& scene, const View& view, const StageRays& stage,
            const SeatGridSettings& settings, bool through);

    /// Whether the scene has any seats at all, chosen or not.
    [[nodiscard]] bool hasSeats() const { return m_hasSeats; }
    /// Free seats whose plane, where they are marked, projects inside, ascending by id.
    [[nodiscard]] std::vector<WorldSeat> freeIn(const ScreenArea& area);
    /// The free seat that is nearest to a pixel, inside the area if one is given, else at most
    /// half a metre (and never less than 12 pixels) away.
    [[nodiscard]] std::optional<WorldSeat> nearestFree(glm::dvec2 pixel,
                                                       const std::optional<ScreenArea>& area);
    void take(SeatId seat);
    void release(SeatId seat);

private:
    struct Place
    {
        WorldSeat seat;
        glm::dvec2 foot{0.0}; ///< logical pixels
        glm::dvec2 mark{0.0}; ///< middle of the seat's plane
        glm::dvec2 lap{0.0};
        double reach = 0.0; ///< half a metre, in pixels
        bool isFree = true;
        enum class Seen : std::uint8_t { Unknown, Yes, No } seen = Seen::Unknown;
    };
    [[nodiscard]] bool isSeen(Place& place) const;
    [[nodiscard]] Place* find(SeatId seat);

    const View m_view;
    const StageRays& m_stage;
    bool m_through;
    bool m_hasSeats = false;
    std::vector<Place> m_places; ///< ascending by seat id
};

} // namespace crowd::model
