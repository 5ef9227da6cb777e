// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "model/base/Color.h"
#include "model/brush/ByteChange.h"
#include "model/brush/ColumnWriting.h"
#include "model/population/FootCells.h"

namespace crowd::model {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// The neighbours of each of a request's individuals, as rows; all stand as before the dab.
class Neighbourhoods
{
public:
    Neighbourhoods(const ChangeRequest& request, float metres)
        : m_request(request), m_people(request.edit.scene().population)
    {
        const std::vector<std::size_t> rows = rowsOf(request);
        const FootCells cells(m_people.column(columns::position), metres, rows);
        m_rows.resize(request.ids.size());
        forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId) {
            cells.forEachNear(row, [&](std::uint32_t other) {
                if (other != row) {
                    m_rows[i].push_back(other);
                }
            });
        });
    }

    /// Calls blend(own, neighbours' rows) for everybody with neighbours and writes what it says.
    template<class T, class Blend>
    void write(ColumnKey<T> key, const Blend& blend, std::vector<IndividualId>& changed) const
    {
        const auto column = m_people.column(key);
        ColumnChange<T> change;
        forEachRow(m_request, [&](std::size_t i, std::size_t row, IndividualId id) {
            if (!m_rows[i].empty()) {
                change.set(id, column[row], blend(row, m_rows[i]));
            }
        });
        change.apply(m_request.edit, key, changed);
    }
    /// The share of the way to the mean.
    [[nodiscard]] double share() const
    {
        const BrushSettings& brush = m_request.settings;
        return brush.buildUp ? static_cast<double>(brush.flow) : 1.0;
    }
    [[nodiscard]] const Population& people() const { return m_people; }

private:
    const ChangeRequest& m_request;
    const Population& m_people;
    std::vector<std::vector<std::uint32_t>> m_rows;
};

/// Values of 0 mean something else where `isZeroApart`: they neither change nor count.
void smoothNumber(const Neighbourhoods& around, ColumnKey<float> key, bool isZeroApart,
                  std::vector<IndividualId>& changed)
{
    const auto column = around.people().column(key);
    around.write(
        key,
        [&](std::size_t row, const std::vector<std::uint32_t>& others) {
            double sum = 0.0;
            int count = 0;
            for (const std::uint32_t other : others) {
                if (!isZeroApart || column[other] != 0.0F) {
                    sum += static_cast<double>(column[other]);
                    ++count;
                }
            }
            if (count == 0 || (isZeroApart && column[row] == 0.0F)) {
                return column[row];
            }
            const auto own = static_cast<double>(column[row]);
            return static_cast<float>(own + (sum / count - own) * around.share());
        },
        changed);
}

/// Values that go round; `turn` in the column's unit.
void smoothCyclic(const Neighbourhoods& around, ColumnKey<float> key, double turn,
                  std::vector<IndividualId>& changed)
{
    const auto column = around.people().column(key);
    around.write(
        key,
        [&](std::size_t row, const std::vector<std::uint32_t>& others) {
            glm::dvec2 sum(0.0);
            for (const std::uint32_t other : others) {
                const double angle = static_cast<double>(column[other]) / turn * kTurn;
                sum += glm::dvec2(std::cos(angle), std::sin(angle));
            }
            if (glm::length(sum) < 1e-6) { // as many one way as the other
                return column[row];
            }
            const double own = static_cast<double>(column[row]) / turn;
            const double way = std::atan2(sum.y, sum.x) / kTurn - own;
            const double now = own + (way - std::round(way)) * around.share();
            const double kept = turn == 1.0 ? now - std::floor(now) : now - std::round(now);
            return static_cast<float>(kept * turn);
        },
        changed);
}

/// The mean colour of those of the same template, in linear light, weighted by strength.
void smoothTint(const Neighbourhoods& around, ColumnKey<Tint> key,
                std::vector<IndividualId>& changed)
{
    const auto column = around.people().column(key);
    const auto templates = around.people().column(columns::templateId);
    const auto linear = [](const Tint& tint) {
        return linearFromSrgb(glm::vec3(tint.red, tint.green, tint.blue) / 255.0F);
    };
    const auto byte = [](float value) {
        return static_cast<std::uint8_t>(std::lround(srgbFromLinear(value) * 255.0F));
    };
    around.write(
        key,
        [&](std::size_t row, const std::vector<std::uint32_t>& others) {
            glm::vec3 sum(0.0F);
            float strength = 0.0F;
            int count = 0;
            for (const std::uint32_t other : others) {
                if (templates[other] == templates[row]) {
                    sum += linear(column[other]) * static_cast<float>(column[other].strength);
                    strength += static_cast<float>(column[other].strength);
                    ++count;
                }
            }
            if (count == 0 || strength == 0.0F) {
                return column[row];
            }
            const auto share = static_cast<float>(around.share());
            const Tint& own = column[row];
            const glm::vec3 from = own.strength == 0 ? sum / strength : linear(own);
            const glm::vec3 now = from + (sum / strength - from) * share;
            const float before = own.strength;
            const float mean = strength / static_cast<float>(count);
            return Tint{byte(now.x), byte(now.y), byte(now.z),
                        static_cast<std::uint8_t>(std::lround(before + (mean - before) * share))};
        },
        changed);
}

} // namespace

void SmoothSettings::prepare(BrushSettings& brush)
{
    brush.selection = BrushSelection::AllInCircle;
    brush.buildUp = true;
}

ChangeResult SmoothSettings::change(const ChangeRequest& request)
{
    const auto& settings = request.settings.as<SmoothSettings>();
    const Neighbourhoods around(request, settings.distance);
    ChangeResult result;
    if (settings.size) {
        smoothNumber(around, columns::height, false, result.changed);
        smoothNumber(around, columns::girth, false, result.changed);
    }
    if (settings.heading) {
        smoothCyclic(around, columns::heading, kTurn, result.changed);
    }
    if (settings.timing) {
        smoothCyclic(around, columns::phase, 1.0, result.changed);
        smoothNumber(around, columns::playbackSpeed, false, result.changed);
    }
    if (settings.walkSpeed) {
        smoothNumber(around, columns::walkSpeed, true, result.changed);
    }
    if (settings.colours) {
        for (int slot = 0; slot < kMaxTintSlots; ++slot) {
            smoothTint(around, columns::tint(slot), result.changed);
        }
    }
    const bool hasAny = settings.size || settings.heading || settings.timing ||
                        settings.walkSpeed || settings.colours;
    result.reason = hasAny ? StrokeReason::Unchanged : StrokeReason::NothingChosen;
    return result;
}

} // namespace crowd::model
