// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "model/base/Random.h"
#include "model/brush/ColumnWriting.h"
#include "model/brush/StrokeEffect.h"
#include "model/pick/StageRays.h"
#include "model/population/FootCells.h"

namespace crowd::model {

namespace {

constexpr int kRounds = 4;
constexpr float kBodyRoom = 0.4F; ///< metres between two foot points, at least

/// Metres over the ground, x and z.
glm::vec2 onGround(const glm::vec3& way)
{
    return {way.x, way.z};
}

/// Everything that one dab moves by.
class PushDab
{
public:
    PushDab(const ChangeRequest& request, const PushSettings& settings)
        : m_request(request), m_settings(settings),
          m_people(request.edit.scene().population.column(columns::position)),
          m_cells(m_people, settings.distance, rowsOf(request)),
          m_middle(middleOf(OperatorShares(request).positions()))
    {
    }

    /// Whether it can say where to.
    [[nodiscard]] bool hasDirection() const
    {
        return m_settings.mode == PushMode::Gather || m_settings.mode == PushMode::Spread ||
               m_request.strokeHeading;
    }
    /// The strength: of dabs that build up in the middle of the circle, falling to 0 at its rim.
    [[nodiscard]] float weight(const glm::vec3& position) const
    {
        const BrushSettings& brush = m_request.settings;
        const auto at = m_request.view.project(position);
        if (!at) {
            return 0.0F;
        }
        if (!brush.hasCircle() || !brush.buildUp || brush.isReevaluated()) {
            return m_settings.strength;
        }
        const double distance =
            glm::distance(glm::dvec2(at->x, at->y), m_request.line.to) / brush.radiusPixels;
        const double inside = std::max(0.0, 1.0 - distance * distance);
        return static_cast<float>(inside * inside) * m_settings.strength;
    }
    /// Where somebody of a row wants to be, before the ground is asked.
    [[nodiscard]] glm::vec3 target(std::size_t row, IndividualId id) const
    {
        const glm::vec3& position = m_people[row];
        const float share = weight(position);
        if (m_settings.mode == PushMode::Spread) {
            return position + apart(row, id) * share;
        }
        const float metres = wayMetres(position) * share;
        if (m_settings.mode == PushMode::Gather) {
            const glm::vec2 way = onGround(m_middle - position);
            const float length = glm::length(way);
            const glm::vec2 step =
                length > 0.0F ? way / length * std::min(metres, length) : glm::vec2(0.0F);
            return position + glm::vec3(step.x, 0.0F, step.y);
        }
        const float heading = *m_request.strokeHeading;
        return position + glm::vec3(std::sin(heading), 0.0F, std::cos(heading)) * metres;
    }

private:
    static glm::vec3 middleOf(std::span<const glm::vec3> positions)
    {
        glm::dvec3 sum(0.0);
        for (const glm::vec3& position : positions) {
            sum += glm::dvec3(position);
        }
        return glm::vec3(sum / static_cast<double>(std::max<std::size_t>(positions.size(), 1)));
    }
    /// How far the pointer has gone since the last dab, at that depth.
    [[nodiscard]] float wayMetres(const glm::vec3& position) const
    {
        const BrushSettings& brush = m_request.settings;
        const auto at = m_request.view.project(position);
        const double pixels = brush.isReevaluated()
                                  ? glm::distance(m_request.line.from, m_request.line.to)
                                  : dabSpacing(brush);
        return at ? static_cast<float>(pixels) / m_request.view.pixelsPerMetre(at->z) : 0.0F;
    }
    /// Half of what is missing to each neighbour.
    [[nodiscard]] glm::vec3 apart(std::size_t row, IndividualId id) const
    {
        glm::vec2 sum(0.0F);
        m_cells.forEachNear(row, [&](std::uint32_t other) {
            glm::vec2 way = onGround(m_people[row] - m_people[other]);
            const float distance = glm::length(way);
            if (other == row || distance >= m_settings.distance) {
                return;
            }
            if (distance < 1e-4F) { // on the same spot: anywhere, but not the same way
                const double angle =
                    2.0 * std::numbers::pi *
                    randomUnit(hashKeys(m_request.seed, hashText("push.apart"), id),
                               DrawPurpose::Heading);
                way = {std::cos(angle), std::sin(angle)};
            } else {
                way /= distance;
            }
            sum += way * ((m_settings.distance - distance) * 0.5F);
        });
        const float length = glm::length(sum);
        if (length > m_settings.distance) {
            sum *= m_settings.distance / length;
        }
        return {sum.x, 0.0F, sum.y};
    }

    const ChangeRequest& m_request;
    const PushSettings& m_settings;
    std::span<const glm::vec3> m_people;
    FootCells m_cells;
    glm::vec3 m_middle;
};

/// Lets people go where they want to, one after the other, where bodies have room.
class PushRoom
{
public:
    PushRoom(std::span<const glm::vec3> people, const std::vector<std::size_t>& rows, float step)
        : m_now(people.begin(), people.end()), m_cells(people, kBodyRoom + 2.0F * step, rows)
    {
    }
    /// Who is too near to somebody already may go anywhere that is no nearer.
    bool move(std::size_t row, const glm::vec3& target)
    {
        float before = std::numeric_limits<float>::max();
        float after = before;
        m_cells.forEachNear(row, [&](std::uint32_t other) {
            if (other != row) {
                before = std::min(before, glm::distance(m_now[row], m_now[other]));
                after = std::min(after, glm::distance(target, m_now[other]));
            }
        });
        const bool hasRoom = after >= kBodyRoom || after >= before;
        if (hasRoom) {
            m_now[row] = target;
        }
        return hasRoom;
    }

private:
    std::vector<glm::vec3> m_now;
    FootCells m_cells; ///< as they stood; nobody has gone further than a step since
};

void comb(const ChangeRequest& request, const PushDab& dab, std::vector<IndividualId>& changed)
{
    const Population& people = request.edit.scene().population;
    const auto headings = people.column(columns::heading);
    const auto positions = people.column(columns::position);
    const auto seats = people.column(columns::seat);
    ColumnChange<float> change;
    forEachRow(request, [&](std::size_t, std::size_t row, IndividualId id) {
        const float way = wrappedAngle(*request.strokeHeading - headings[row]);
        if (seats[row] == kNoSeat) {
            change.set(id, headings[row],
                       wrappedAngle(headings[row] + way * dab.weight(positions[row])));
        }
    });
    change.apply(request.edit, columns::heading, changed);
}

/// False where nobody stands.
bool move(const ChangeRequest& request, const PushDab& dab, std::vector<IndividualId>& changed)
{
    const Population& people = request.edit.scene().population;
    const auto positions = people.column(columns::position);
    const auto seats = people.column(columns::seat);
    std::vector<std::pair<std::size_t, glm::vec3>> targets; ///< rows, in the order of ids
    std::vector<IndividualId> ids;
    float step = 0.0F;
    forEachRow(request, [&](std::size_t, std::size_t row, IndividualId id) {
        if (seats[row] == kNoSeat) {
            glm::vec3 target = dab.target(row, id);
            target.y = request.stage != nullptr ? request.stage->heightNear(target) : target.y;
            step = std::max(step, glm::distance(target, positions[row]));
            targets.emplace_back(row, target);
            ids.push_back(id);
        }
    });
    PushRoom room(positions, rowsOf(request), step);
    ColumnChange<glm::vec3> change;
    // Who stands in the way goes first: the order of ids is tried from both ends.
    std::vector<char> isMoved(targets.size(), 0);
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t k = 0; k < targets.size(); ++k) {
            const std::size_t i = round % 2 == 0 ? k : targets.size() - 1 - k;
            if (isMoved[i] == 0 && room.move(targets[i].first, targets[i].second)) {
                isMoved[i] = 1;
            }
        }
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (isMoved[i] != 0) {
            change.set(ids[i], positions[targets[i].first], targets[i].second);
        }
    }
    change.apply(request.edit, columns::position, changed);
    return !targets.empty();
}

} // namespace

void PushSettings::prepare(BrushSettings& brush)
{
    brush.selection = BrushSelection::AllInCircle;
    brush.buildUp = true;
    brush.radiusPixels = 80.0F;
}

ChangeResult PushSettings::change(const ChangeRequest& request)
{
    const auto& settings = request.settings.as<PushSettings>();
    const PushDab dab(request, settings);
    ChangeResult result;
    if (!dab.hasDirection()) {
        result.reason = StrokeReason::NoDirection;
        return result;
    }
    if (settings.mode == PushMode::Comb) {
        comb(request, dab, result.changed);
    }
    result.reason =
        move(request, dab, result.changed) ? StrokeReason::Unchanged : StrokeReason::OnlySeated;
    return result;
}

} // namespace crowd::model
