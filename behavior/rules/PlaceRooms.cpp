// SPDX-License-Identifier: MIT
#include "behavior/rules/PlaceRooms.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/scene/PlaceShape.h"

namespace crowd::behavior {

namespace {

constexpr std::size_t kMostWays = 6; ///< looked for, of those who want to know the nearest place

} // namespace

void PlaceRooms::setPlaces(std::vector<model::Place> places, std::vector<model::Path> paths)
{
    m_places = std::move(places);
    m_paths = std::move(paths);
    m_rooms.assign(m_places.size(), {});
    m_isCounted = false;
}

std::size_t PlaceRooms::indexOf(model::PlaceId id) const
{
    const auto found = std::ranges::find(m_places, id, &model::Place::id);
    return static_cast<std::size_t>(found - m_places.begin());
}

const model::Place* PlaceRooms::find(model::PlaceId id) const
{
    const std::size_t index = indexOf(id);
    return index < m_places.size() ? &m_places[index] : nullptr;
}

bool PlaceRooms::isInside(model::PlaceId id, const glm::vec3& position) const
{
    const model::Place* place = find(id);
    return place != nullptr && model::isWithin(*place, position);
}

void PlaceRooms::count(std::span<const Guest> guests)
{
    m_rooms.assign(m_places.size(), {});
    for (const Guest& guest : guests) {
        const std::size_t held = guest.holds != 0 ? indexOf(guest.holds) : m_places.size();
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            const bool isIn = model::isWithin(m_places[i], guest.position);
            m_rooms[i].inside += isIn ? 1U : 0U;
            m_rooms[i].taken += held == i || (isIn && guest.holds == 0) ? 1U : 0U;
            m_rooms[i].held += held == i ? 1U : 0U;
        }
    }
    m_isCounted = true;
}

void PlaceRooms::move(model::PlaceId from, model::PlaceId to)
{
    const std::size_t left = from != 0 ? indexOf(from) : m_places.size();
    const std::size_t taken = to != 0 ? indexOf(to) : m_places.size();
    if (left < m_rooms.size() && m_rooms[left].held > 0) {
        --m_rooms[left].taken;
        --m_rooms[left].held;
    }
    if (taken < m_rooms.size()) {
        ++m_rooms[taken].taken;
        ++m_rooms[taken].held;
    }
}

bool PlaceRooms::isFull(model::PlaceId id) const
{
    const std::size_t index = indexOf(id);
    return index < m_places.size() && m_rooms[index].taken >= model::roomOf(m_places[index]);
}

std::uint32_t PlaceRooms::inside(model::PlaceId id) const
{
    const std::size_t index = indexOf(id);
    return index < m_rooms.size() ? m_rooms[index].inside : 0;
}

bool PlaceRooms::isFree(model::PlaceId id, model::PlaceId holds, bool isInLine) const
{
    const std::size_t index = indexOf(id);
    if (index >= m_rooms.size()) {
        return false;
    }
    const model::Place& place = m_places[index];
    const std::uint32_t room = isInLine && place.capacity == 0 ? 1 : model::roomOf(place);
    return m_rooms[index].taken < room + (holds == id ? 1U : 0U);
}

/// People who stand in the way of a line do not take a place in it.
bool PlaceRooms::hasRoomInLine(model::PlaceId id) const
{
    const std::size_t index = indexOf(id);
    return index < m_rooms.size() && m_rooms[index].held < std::max(1U, m_places[index].capacity);
}

std::vector<model::PlaceId> PlaceRooms::candidates(const PlaceWish& wish) const
{
    std::vector<model::PlaceId> ids;
    if (wish.path != 0) {
        const auto found = std::ranges::find(m_paths, wish.path, &model::Path::id);
        return found == m_paths.end() ? ids : found->places;
    }
    const model::Place* named = wish.place != 0 ? find(wish.place) : nullptr;
    for (const model::Place& each : m_places) {
        const bool isMeant =
            wish.place == 0 ? each.role == wish.role : named != nullptr && each.name == named->name;
        if (isMeant) {
            ids.push_back(each.id);
        }
    }
    return ids;
}

void PlaceRooms::setLines(const std::vector<PlaceWish>& lines)
{
    m_lines.clear();
    for (const PlaceWish& line : lines) {
        m_lines.push_back(candidates(line));
    }
}

bool PlaceRooms::hasAny(const PlaceWish& wish) const
{
    if (wish.choice == model::PlaceChoice::Given) {
        return find(wish.place) != nullptr;
    }
    const std::vector<model::PlaceId> ids = candidates(wish);
    return std::ranges::any_of(ids, [this](model::PlaceId id) { return find(id) != nullptr; });
}

bool PlaceRooms::isLine(const PlaceWish& wish) const
{
    return !m_lines.empty() && std::ranges::find(m_lines, candidates(wish)) != m_lines.end();
}

bool PlaceRooms::isAmong(const PlaceWish& wish, model::PlaceId place) const
{
    const std::vector<model::PlaceId> ids = candidates(wish);
    return place != 0 && std::ranges::find(ids, place) != ids.end();
}

/// Who has a place in the line keeps it.
std::optional<model::PlaceId> PlaceRooms::behindTheLast(const std::vector<model::PlaceId>& line,
                                                        model::PlaceId holds) const
{
    if (holds != 0 && std::ranges::find(line, holds) != line.end()) {
        return holds;
    }
    std::optional<model::PlaceId> behind;
    for (auto id = line.rbegin(); id != line.rend(); ++id) {
        const std::size_t index = indexOf(*id);
        if (hasRoomInLine(*id)) {
            behind = *id;
        }
        if (index < m_rooms.size() && m_rooms[index].held > 0) {
            break;
        }
    }
    return behind;
}

/// No way is shorter than straight on: those further away than the best one are not asked about.
std::optional<model::PlaceId> PlaceRooms::nearest(const std::vector<model::PlaceId>& ids,
                                                  const glm::vec3& near,
                                                  const WayLength& wayTo) const
{
    struct Candidate
    {
        float metres = 0.0F; ///< straight on
        const model::Place* place = nullptr;
    };
    std::vector<Candidate> candidates;
    for (const model::PlaceId id : ids) {
        if (const model::Place* place = find(id)) {
            candidates.push_back({flatDistance(place->position, near), place});
        }
    }
    if (candidates.empty()) {
        return std::nullopt;
    }
    std::ranges::stable_sort(candidates, {}, &Candidate::metres);
    const model::Place* best = candidates.front().place; // where no way leads to any
    float shortest = std::numeric_limits<float>::infinity();
    const std::size_t asked = wayTo && candidates.size() > 1 ? kMostWays : 0;
    for (std::size_t i = 0; i < std::min(asked, candidates.size()); ++i) {
        if (candidates[i].metres >= shortest) {
            break;
        }
        const float metres = wayTo(*candidates[i].place);
        if (metres < shortest) {
            shortest = metres;
            best = candidates[i].place;
        }
    }
    return best->id;
}

std::optional<model::PlaceId> PlaceRooms::choose(const PlaceWish& wish, const glm::vec3& near,
                                                 model::PlaceId holds, const WayLength& wayTo) const
{
    if (wish.choice == model::PlaceChoice::Given) {
        return find(wish.place) != nullptr ? std::optional(wish.place) : std::nullopt;
    }
    std::vector<model::PlaceId> ids = candidates(wish);
    if (wish.choice == model::PlaceChoice::Ahead) {
        const auto own = std::ranges::find(ids, holds);
        const bool canMove = own != ids.end() && own != ids.begin() && hasRoomInLine(*(own - 1));
        return canMove ? std::optional(*(own - 1)) : std::nullopt;
    }
    const bool isInLine = wish.choice == model::PlaceChoice::FirstFree;
    if (isInLine && isLine(wish)) {
        return behindTheLast(ids, holds);
    }
    if (wish.choice != model::PlaceChoice::Nearest) {
        std::erase_if(ids, [&](model::PlaceId id) { return !isFree(id, holds, isInLine); });
    }
    if (isInLine) {
        return ids.empty() ? std::nullopt : std::optional(ids.front());
    }
    return nearest(ids, near, wayTo);
}

} // namespace crowd::behavior
