// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "model/rules/Rule.h"
#include "model/scene/Path.h"

namespace crowd::behavior {

/// Between two points seen from above, metres.
[[nodiscard]] inline float flatDistance(const glm::vec3& a, const glm::vec3& b)
{
    const float x = a.x - b.x;
    const float z = a.z - b.z;
    return std::sqrt(x * x + z * z);
}

/// Which place somebody is to go to; see model::PlaceChoice.
struct PlaceWish
{
    model::PlaceChoice choice = model::PlaceChoice::Given;
    model::PlaceId place = 0;
    model::PathId path = 0;
    /// Of the places that are meant where no path and no place says which.
    model::PlaceRole role = model::PlaceRole::Spot;
};

/// Metres of somebody's way to a place, no fewer than straight on; infinite: he does not get there.
using WayLength = std::function<float(const model::Place&)>;

/// Places that people ask for by what they are, and how many have taken each: whoever is on his
/// way to one, or in one and on his way to no other. A place without stated room has room for as
/// many as can stand in it (model::roomOf), but for one where people line up, which they do when
/// they go to the first free place of a path or to the one ahead. Where they move up, the first
/// free place is the one behind the last that somebody has, so that nobody jumps the queue, and
/// whoever only stands in a place does not take it. Counted once a step, when somebody asks.
class PlaceRooms
{
public:
    /// One of the people, as far as places are concerned.
    struct Guest
    {
        glm::vec3 position{0.0F};
        model::PlaceId holds = 0; ///< the place that he goes to or has gone to; 0: none
    };

    void setPlaces(std::vector<model::Place> places, std::vector<model::Path> paths);
    /// On whose places people move up.
    void setLines(const std::vector<PlaceWish>& lines);
    [[nodiscard]] std::span<const model::Place> places() const { return m_places; }
    [[nodiscard]] const model::Place* find(model::PlaceId id) const;
    [[nodiscard]] bool isInside(model::PlaceId id, const glm::vec3& position) const;

    /// People have moved: the next one who asks counts anew.
    void forget() { m_isCounted = false; }
    [[nodiscard]] bool isCounted() const { return m_isCounted; }
    void count(std::span<const Guest> guests);
    /// Somebody takes another place than before.
    void move(model::PlaceId from, model::PlaceId to);

    /// As last counted.
    [[nodiscard]] bool isFull(model::PlaceId id) const;
    [[nodiscard]] std::uint32_t inside(model::PlaceId id) const;
    /// See model::PlaceChoice; `near` is where he is, `holds` what he has. The nearest one is that
    /// with the shortest way, where `wayTo` says how long they are: asked of few, and of none where
    /// there is no choice. Nothing: there is no such place now.
    [[nodiscard]] std::optional<model::PlaceId> choose(const PlaceWish& wish, const glm::vec3& near,
                                                       model::PlaceId holds,
                                                       const WayLength& wayTo = {}) const;
    /// Whether there is a place that could be meant, free or not.
    [[nodiscard]] bool hasAny(const PlaceWish& wish) const;
    /// Whether people move up on those places.
    [[nodiscard]] bool isLine(const PlaceWish& wish) const;
    /// Whether that place is one of those meant.
    [[nodiscard]] bool isAmong(const PlaceWish& wish, model::PlaceId place) const;

private:
    struct Room
    {
        std::uint32_t taken = 0;
        std::uint32_t held = 0; ///< of those: by people who were sent there
        std::uint32_t inside = 0;
    };

    [[nodiscard]] std::vector<model::PlaceId> candidates(const PlaceWish& wish) const;
    /// Has room for one more beside who holds it himself.
    [[nodiscard]] bool isFree(model::PlaceId id, model::PlaceId holds, bool isInLine) const;
    [[nodiscard]] bool hasRoomInLine(model::PlaceId id) const;
    [[nodiscard]] std::optional<model::PlaceId>
    behindTheLast(const std::vector<model::PlaceId>& line, model::PlaceId holds) const;
    [[nodiscard]] std::optional<model::PlaceId> nearest(const std::vector<model::PlaceId>& ids,
                                                        const glm::vec3& near,
                                                        const WayLength& wayTo) const;
    [[nodiscard]] std::size_t indexOf(model::PlaceId id) const;

    std::vector<model::Place> m_places; ///< ascending ids
    std::vector<model::Path> m_paths;
    std::vector<Room> m_rooms; ///< one per place
    std::vector<std::vector<model::PlaceId>> m_lines;
    bool m_isCounted = false;
};

} // namespace crowd::behavior
