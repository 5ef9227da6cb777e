// SPDX-License-Identifier: MIT
#include "model/relations/RelatedPeople.h"

#include <algorithm>

#include "model/brush/Posture.h"

namespace crowd::model {

namespace {

constexpr float kSeatReach = 8.0F; ///< metres from where a copy would be to a seat of its own

/// The seats of a scene that nobody has, from west to east.
class FreeSeats
{
public:
    explicit FreeSeats(const Scene& scene) : m_seats(scene.worldSeats())
    {
        const auto column = scene.population.column(columns::seat);
        std::vector<SeatId> taken(column.begin(), column.end());
        std::ranges::sort(taken);
        std::erase_if(m_seats, [&taken](const WorldSeat& seat) {
            return std::ranges::binary_search(taken, seat.id);
        });
        std::ranges::stable_sort(m_seats, {}, &FreeSeats::east);
        m_isTaken.resize(m_seats.size());
    }

    /// The nearest one, which is taken from now on; null: none is near.
    [[nodiscard]] const WorldSeat* take(const glm::vec3& near)
    {
        float least = kSeatReach * kSeatReach;
        std::size_t best = m_seats.size();
        const auto first =
            std::ranges::lower_bound(m_seats, near.x - kSeatReach, {}, &FreeSeats::east);
        for (auto seat = first; seat != m_seats.end() && east(*seat) <= near.x + kSeatReach;
             ++seat) {
            const glm::vec3 way = seat->seat.position - near;
            const float distance = glm::dot(way, way);
            const auto index = static_cast<std::size_t>(seat - m_seats.begin());
            if (distance < least && !m_isTaken[index]) {
                least = distance;
                best = index;
            }
        }
        if (best == m_seats.size()) {
            return nullptr;
        }
        m_isTaken[best] = true;
        return &m_seats[best];
    }

private:
    static float east(const WorldSeat& seat) { return seat.seat.position.x; }

    std::vector<WorldSeat> m_seats;
    std::vector<bool> m_isTaken;
};

/// Who sits gets a seat of his own near where he is now, or stands up.
void seatCopies(const Scene& scene, IndividualRows& rows)
{
    const auto seats = rows.column(columns::seat);
    if (std::ranges::all_of(seats, [](SeatId seat) { return seat == kNoSeat; })) {
        return;
    }
    FreeSeats free(scene);
    for (std::size_t row = 0; row < rows.ids.size(); ++row) {
        if (seats[row] == kNoSeat) {
            continue;
        }
        const TemplateEntry* entry = scene.findTemplate(rows.column(columns::templateId)[row]);
        if (const WorldSeat* seat = free.take(rows.column(columns::position)[row])) {
            sitDown(entry, rows, row, *seat);
        } else {
            standUp(entry, rows, row);
        }
    }
}

void makeSet(std::vector<IndividualId>& ids)
{
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

void copyRelations(SceneEdit& edit, std::span<const IndividualId> originals,
                   std::span<const IndividualId> copies)
{
    std::vector<Relation> made;
    for (std::size_t i = 0; i < originals.size(); ++i) {
        for (const RelationLink& link : edit.scene().relations.of(originals[i])) {
            const auto other = std::ranges::lower_bound(originals, link.other);
            if (link.isOut && other != originals.end() && *other == link.other) {
                const auto index = static_cast<std::size_t>(other - originals.begin());
                made.push_back({copies[i], copies[index], link.strength, link.kind});
            }
        }
    }
    edit.relate(made);
}

} // namespace

std::vector<Relation> relationsOf(const Scene& scene, std::span<const IndividualId> ids,
                                  RelationKindId kind)
{
    std::vector<Relation> found;
    for (const IndividualId id : ids) {
        for (const RelationLink& link : scene.relations.of(id)) {
            if (kind == 0 || link.kind == kind) {
                found.push_back(link.isOut ? Relation{id, link.other, link.strength, link.kind}
                                           : Relation{link.other, id, link.strength, link.kind});
            }
        }
    }
    return found;
}

std::vector<IndividualId> relatedTo(const Scene& scene, std::span<const IndividualId> ids,
                                    RelationKindId kind)
{
    std::vector<IndividualId> found;
    for (const IndividualId id : ids) {
        for (const RelationLink& link : scene.relations.of(id)) {
            const RelationKind* its = findRelation(scene.relationKinds, link.kind);
            const bool isMeant = kind == 0 || link.kind == kind;
            if (isMeant && its != nullptr && (its->isMutual || link.isOut)) {
                found.push_back(link.other);
            }
        }
    }
    makeSet(found);
    return found;
}

std::vector<IndividualId> withRelated(const Scene& scene, std::span<const IndividualId> ids,
                                      RelationKindId kind)
{
    std::vector<IndividualId> all(ids.begin(), ids.end());
    for (const IndividualId id : ids) {
        for (const RelationLink& link : scene.relations.of(id)) {
            if (kind == 0 || link.kind == kind) {
                all.push_back(link.other);
            }
        }
    }
    makeSet(all);
    return all;
}

std::vector<IndividualId> duplicate(SceneEdit& edit, std::span<const IndividualId> ids,
                                    const glm::vec3& offset)
{
    if (ids.empty()) {
        return {};
    }
    IndividualRows rows = edit.scene().population.rows(ids);
    for (glm::vec3& at : rows.column(columns::position)) {
        at += offset;
    }
    seatCopies(edit.scene(), rows);
    std::vector<IndividualId> copies = edit.addIndividuals(std::move(rows));
    copyRelations(edit, ids, copies);
    return copies;
}

} // namespace crowd::model
