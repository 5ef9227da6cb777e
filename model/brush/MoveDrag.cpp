// SPDX-License-Identifier: MIT
#include "model/brush/MoveDrag.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "model/brush/Posture.h"
#include "model/brush/StrokeText.h"
#include "model/document/SceneEdit.h"

namespace crowd::model {

namespace {

constexpr float kSnapMetres = 0.7F;

} // namespace

struct MoveDrag::Private
{
    /// A seat, and who of those who are not dragged sits there; 0: nobody.
    struct Place
    {
        WorldSeat seat;
        IndividualId sitter = 0;
        bool isTaken = false; ///< by one of the dragged, as far as they are placed
    };
    /// Who has to leave his seat to one of the dragged, by the row of that one.
    struct Displaced
    {
        IndividualId id = 0;
        std::size_t by = 0;
    };

    SceneDocument& document;
    BrushContext context;
    std::vector<IndividualId> ids; ///< ascending
    bool ontoSeats = false;
    PointerInput press;
    PointerInput current;
    std::unique_ptr<SceneEdit> edit;
    std::vector<Place> places;
    std::optional<SurfaceHit> grip; ///< surface under the press
    bool isOver = false;

    void findPlaces();
    void apply();
    [[nodiscard]] std::optional<glm::vec3> displacement() const;
    [[nodiscard]] Place* nearestPlace(const glm::vec3& to);
    [[nodiscard]] std::vector<Displaced> moveDragged(IndividualRows& rows, const glm::vec3& way);
    void moveDisplaced(const std::vector<Displaced>& displaced, const IndividualRows& former);
    void write(std::span<const IndividualId> whom, const IndividualRows& rows);
};

void MoveDrag::Private::findPlaces()
{
    const Population& people = document.scene().population;
    std::unordered_map<SeatId, IndividualId> sitters;
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (!std::ranges::binary_search(ids, people.ids()[row])) {
            sitters.emplace(people.column(columns::seat)[row], people.ids()[row]);
        }
    }
    for (const WorldSeat& seat : document.scene().worldSeats()) {
        const auto sitter = sitters.find(seat.id);
        places.push_back({seat, sitter == sitters.end() ? 0 : sitter->second});
    }
}

std::optional<glm::vec3> MoveDrag::Private::displacement() const
{
    const auto target = context.stage.hit(context.view.rayThrough(glm::vec2(current.pixels())));
    if (!grip || !target) {
        return std::nullopt;
    }
    return target->point - grip->point;
}

MoveDrag::Private::Place* MoveDrag::Private::nearestPlace(const glm::vec3& to)
{
    Place* nearest = nullptr;
    float nearestDistance = kSnapMetres;
    for (Place& place : places) {
        const float distance = glm::distance(place.seat.seat.position, to);
        if (!place.isTaken && distance < nearestDistance) {
            nearest = &place;
            nearestDistance = distance;
        }
    }
    return nearest;
}

/// Those who come onto a seat change places with whoever sits there.
std::vector<MoveDrag::Private::Displaced> MoveDrag::Private::moveDragged(IndividualRows& rows,
                                                                         const glm::vec3& way)
{
    std::vector<Displaced> displaced;
    for (Place& place : places) {
        place.isTaken = false;
    }
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const TemplateEntry* entry =
            edit->scene().findTemplate(rows.column(columns::templateId)[i]);
        glm::vec3& position = rows.column(columns::position)[i];
        position += way;
        Place* target = ontoSeats ? nearestPlace(position) : nullptr;
        if (target == nullptr) {
            position.y = context.stage.heightNear(position);
            standUp(entry, rows, i);
            continue;
        }
        target->isTaken = true;
        if (target->sitter != 0) {
            displaced.push_back({target->sitter, i});
        }
        sitDown(entry, rows, i, target->seat);
    }
    return displaced;
}

/// To where the one who displaced them was; if another of the dragged has come there, to where one
/// of the others was.
void MoveDrag::Private::moveDisplaced(const std::vector<Displaced>& displaced,
                                      const IndividualRows& former)
{
    std::vector<bool> isLeft(ids.size(), true); // the seat or spot that a dragged one had
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const SeatId seat = former.column(columns::seat)[i];
        isLeft[i] = std::ranges::none_of(
            places, [seat](const Place& place) { return place.isTaken && place.seat.id == seat; });
    }
    std::vector<IndividualId> whom;
    whom.reserve(displaced.size());
    for (const Displaced& each : displaced) {
        whom.push_back(each.id);
    }
    std::ranges::sort(whom);
    IndividualRows rows = edit->scene().population.rows(whom);
    for (const Displaced& each : displaced) {
        const auto free = isLeft[each.by] ? isLeft.begin() + static_cast<std::ptrdiff_t>(each.by)
                                          : std::ranges::find(isLeft, true);
        const auto from = static_cast<std::size_t>(free - isLeft.begin());
        *free = false;
        const auto row =
            static_cast<std::size_t>(std::ranges::lower_bound(whom, each.id) - whom.begin());
        const TemplateEntry* entry =
            edit->scene().findTemplate(rows.column(columns::templateId)[row]);
        const auto seat = std::ranges::find(places, former.column(columns::seat)[from],
                                            [](const Place& place) { return place.seat.id; });
        if (seat != places.end()) {
            sitDown(entry, rows, row, seat->seat);
        } else {
            rows.column(columns::position)[row] = former.column(columns::position)[from];
            standUp(entry, rows, row);
        }
    }
    write(whom, rows);
}

void MoveDrag::Private::write(std::span<const IndividualId> whom, const IndividualRows& rows)
{
    for (const ColumnId column :
         {ColumnId::Position, ColumnId::Heading, ColumnId::Clip, ColumnId::Seat}) {
        edit->setColumn(column, whom, rows.bytes[static_cast<std::size_t>(column)]);
    }
}

void MoveDrag::Private::apply()
{
    edit->rollback();
    const auto way = displacement();
    if (!way || press.grid == current.grid) {
        return;
    }
    const IndividualRows former = edit->scene().population.rows(ids);
    IndividualRows rows = former;
    const std::vector<Displaced> displaced = moveDragged(rows, *way);
    write(ids, rows);
    if (!displaced.empty()) {
        moveDisplaced(displaced, former);
    }
}

MoveDrag::MoveDrag(std::unique_ptr<Private> data) : m_private(std::move(data)) {}
MoveDrag::~MoveDrag() = default;

std::unique_ptr<MoveDrag> MoveDrag::begin(SceneDocument& document, const BrushContext& context,
                                          std::span<const IndividualId> ids, bool ontoSeats,
                                          const PointerInput& press)
{
    auto edit = document.beginEdit();
    if (!edit) {
        return nullptr;
    }
    auto data = std::make_unique<Private>(Private{document,
                                                  context,
                                                  {ids.begin(), ids.end()},
                                                  ontoSeats,
                                                  press,
                                                  press,
                                                  std::move(edit).value(),
                                                  {},
                                                  {},
                                                  false});
    data->grip = context.stage.hit(context.view.rayThrough(glm::vec2(press.pixels())));
    if (ontoSeats) {
        data->findPlaces();
    }
    return std::unique_ptr<MoveDrag>(new MoveDrag(std::move(data)));
}

void MoveDrag::move(const PointerInput& input)
{
    if (!m_private->isOver) {
        m_private->current = input;
        m_private->apply();
    }
}

StrokeOutcome MoveDrag::finish()
{
    Private& d = *m_private;
    StrokeOutcome outcome;
    if (d.isOver) {
        outcome.reason = StrokeReason::Cancelled;
        return outcome;
    }
    d.isOver = true;
    outcome.isCommitted = d.edit->commit(moveText(static_cast<int>(d.ids.size())));
    d.edit.reset();
    outcome.affected = outcome.isCommitted ? static_cast<int>(d.ids.size()) : 0;
    outcome.reason = outcome.isCommitted || d.press.grid == d.current.grid
                         ? StrokeReason::None
                         : StrokeReason::NothingUnderBrush;
    outcome.message = reasonText(outcome.reason);
    return outcome;
}

void MoveDrag::cancel()
{
    m_private->isOver = true;
    m_private->edit.reset();
}

} // namespace crowd::model
