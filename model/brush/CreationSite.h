// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

#include "model/brush/BrushContext.h"
#include "model/brush/BrushSettings.h"
#include "model/brush/NeighbourGrid.h"
#include "model/brush/SeatMap.h"
#include "model/brush/Stroke.h"
#include "model/pick/ScreenArea.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// A place for somebody new.
struct Spot
{
    glm::vec3 position{0.0F}; ///< foot point, world frame
    SeatId seat = kNoSeat;
    float seatHeading = 0.0F; ///< radians, on a seat
    std::uint64_t key = 0;    ///< of all that is random about who comes here
};

/// Where a creation brush can put people during one stroke: free seats with the seat grid on,
/// else stage surfaces under 50° and the ground, where people can walk unless they are created
/// anywhere, with the minimal distance to everybody. People under the cursor are looked through.
/// Spots that were given out are taken.
class CreationSite
{
public:
    CreationSite(const Scene& scene, const BrushContext& context, const BrushSettings& settings,
                 std::uint64_t seed);

    /// One spot at a pixel; on seats the nearest free one, within `area` if one is given.
    [[nodiscard]] std::optional<Spot> at(glm::dvec2 pixel, const std::optional<ScreenArea>& area);
    /// Fills an area: by persons per m², or by per cent of the free seats. With `isWhole` the
    /// share of seats is met exactly; without, each seat is tried once a stroke.
    [[nodiscard]] std::vector<Spot> fill(const ScreenArea& area, bool isWhole);
    /// Gives back all spots given out so far.
    void reset();

    /// Why the last query gave less than it could have.
    [[nodiscard]] StrokeReason reason() const { return m_reason; }

private:
    struct Cell
    {
        int x, z;
    };
    [[nodiscard]] std::optional<Spot> onSeat(glm::dvec2 pixel,
                                             const std::optional<ScreenArea>& area);
    [[nodiscard]] std::optional<Spot> onSurface(glm::dvec2 pixel);
    [[nodiscard]] std::vector<Spot> fillSeats(const ScreenArea& area, bool isWhole);
    [[nodiscard]] std::vector<Spot> fillSurface(const ScreenArea& area);
    [[nodiscard]] std::vector<Cell> cellsUnder(const ScreenArea& area);
    /// Why somebody cannot stand on a surface; None: he can.
    [[nodiscard]] StrokeReason reasonAgainst(const SurfaceHit& surface) const;
    [[nodiscard]] bool isKeptOutOf(const glm::vec3& point) const;
    [[nodiscard]] std::optional<glm::vec3> candidate(const ScreenArea& area, Cell cell, int attempt,
                                                     StrokeReason& against) const;
    [[nodiscard]] std::uint64_t keyOf(Cell cell) const;
    [[nodiscard]] GroundDisc discAt(const glm::vec3& position, std::uint64_t key) const;
    /// Of who comes there: drawn by `key`, or, where he needs more room than there is, somebody
    /// else of the mix. None: nobody has room.
    [[nodiscard]] std::optional<std::uint64_t> fittingKey(const glm::vec3& position,
                                                          std::uint64_t key) const;
    void take(const Spot& spot);

    const Scene& m_scene;
    const BrushContext& m_context;
    const BrushSettings& m_settings;
    std::uint64_t m_seed;
    SeatMap m_seats;
    bool m_usesSeats;
    WalkableGroundPtr m_ground; ///< null: anywhere
    NeighbourGrid m_neighbours;
    std::size_t m_present; ///< people that were there before
    std::uint64_t m_given = 0;
    std::vector<SeatId> m_takenSeats;
    std::unordered_set<std::uint64_t> m_tried; ///< cells and seats that had their turn
    StrokeReason m_reason = StrokeReason::None;
};

} // namespace crowd::model
