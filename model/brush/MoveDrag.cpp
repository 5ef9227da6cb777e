// SPDX-License-Identifier: MIT
#include "model/brush/MoveDrag.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/brush/ClipChoice.h"
#include "model/brush/Operator.h"
#include "model/brush/StrokeText.h"
#include "model/document/SceneEdit.h"

namespace crowd::model {

namespace {

constexpr float kSnapMetres = 0.7F;

} // namespace

struct MoveDrag::Private
{
    SceneDocument& document;
    BrushContext context;
    std::vector<IndividualId> ids; ///< ascending
    bool ontoSeats = false;
    PointerInput press;
    PointerInput current;
    std::unique_ptr<SceneEdit> edit;
    std::vector<WorldSeat> freeSeats; ///< those of the dragged included
    std::optional<SurfaceHit> grip;   ///< surface under the press
    bool isOver = false;

    void findFreeSeats();
    void apply();
    [[nodiscard]] std::optional<glm::vec3> displacement() const;
    [[nodiscard]] const WorldSeat* nearestSeat(const glm::vec3& to,
                                               const std::vector<bool>& isTaken) const;
    void standUp(const TemplateEntry* entry, SeatId seatBefore, std::uint16_t& clip) const;
};

void MoveDrag::Private::findFreeSeats()
{
    const Scene& scene = document.scene();
    std::vector<SeatId> taken;
    for (std::size_t row = 0; row < scene.population.size(); ++row) {
        if (!std::ranges::binary_search(ids, scene.population.ids()[row])) {
            taken.push_back(scene.population.column(columns::seat)[row]);
        }
    }
    std::ranges::sort(taken);
    freeSeats = scene.worldSeats();
    std::erase_if(freeSeats, [&](const WorldSeat& seat) {
        return std::ranges::binary_search(taken, seat.id);
    });
}

std::optional<glm::vec3> MoveDrag::Private::displacement() const
{
    const auto target = context.stage.hit(context.view.rayThrough(glm::vec2(current.pixels())));
    if (!grip || !target) {
        return std::nullopt;
    }
    return target->point - grip->point;
}

const WorldSeat* MoveDrag::Private::nearestSeat(const glm::vec3& to,
                                                const std::vector<bool>& isTaken) const
{
    const WorldSeat* nearest = nullptr;
    float nearestDistance = kSnapMetres;
    for (std::size_t i = 0; i < freeSeats.size(); ++i) {
        const float distance = glm::distance(freeSeats[i].seat.position, to);
        if (!isTaken[i] && distance < nearestDistance) {
            nearest = &freeSeats[i];
            nearestDistance = distance;
        }
    }
    return nearest;
}

void MoveDrag::Private::standUp(const TemplateEntry* entry, SeatId seatBefore,
                                std::uint16_t& clip) const
{
    if (entry != nullptr && seatBefore != kNoSeat && clip == usualClip(*entry, true)) {
        clip = usualClip(*entry, false);
    }
}

void MoveDrag::Private::apply()
{
    edit->rollback();
    const auto way = displacement();
    if (!way || press.grid == current.grid) {
        return;
    }
    const Scene& scene = edit->scene();
    IndividualRows rows = scene.population.rows(ids);
    std::vector<bool> isTaken(freeSeats.size(), false);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const TemplateEntry* entry = scene.findTemplate(rows.column(columns::templateId)[i]);
        glm::vec3& position = rows.column(columns::position)[i];
        SeatId& seat = rows.column(columns::seat)[i];
        std::uint16_t& clip = rows.column(columns::clip)[i];
        position += *way;
        const WorldSeat* target = ontoSeats ? nearestSeat(position, isTaken) : nullptr;
        if (target != nullptr) {
            isTaken[static_cast<std::size_t>(target - freeSeats.data())] = true;
            if (entry != nullptr && clip == usualClip(*entry, false)) {
                clip = usualClip(*entry, true);
            }
            seat = target->id;
            position = target->seat.position;
            rows.column(columns::heading)[i] = wrappedAngle(target->seat.headingRadians);
        } else {
            position.y = context.stage.heightNear(position);
            standUp(entry, seat, clip);
            seat = kNoSeat;
        }
    }
    for (const ColumnId column :
         {ColumnId::Position, ColumnId::Heading, ColumnId::Clip, ColumnId::Seat}) {
        edit->setColumn(column, ids, rows.bytes[static_cast<std::size_t>(column)]);
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
        data->findFreeSeats();
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
