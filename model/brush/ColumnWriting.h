// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "model/brush/Operator.h"
#include "model/brush/PropertyChange.h"
#include "model/brush/SlotChoice.h"
#include "model/brush/TakenFrom.h"
#include "model/describe/FieldChecks.h"

/// What changes of properties are made of.
namespace crowd::model {

/// Values of one column that differ from today's, in ascending order of id.
template<class T>
class ColumnChange
{
public:
    void set(IndividualId id, const T& before, const T& after)
    {
        if (!(before == after)) {
            m_ids.push_back(id);
            m_values.push_back(after);
        }
    }
    void apply(SceneEdit& edit, ColumnKey<T> key, std::vector<IndividualId>& changed) const
    {
        edit.setColumn(key, m_ids, std::span<const T>(m_values));
        std::vector<IndividualId> all;
        std::ranges::set_union(changed, m_ids, std::back_inserter(all));
        changed = std::move(all);
    }

private:
    std::vector<IndividualId> m_ids;
    std::vector<T> m_values;
};

/// Asks operators for the individuals of a request.
class OperatorShares
{
public:
    explicit OperatorShares(const ChangeRequest& request) : m_request(request) {}

    /// What the brush's own operator says, for a purpose whose number is kept.
    [[nodiscard]] OperatorResult of(DrawPurpose purpose, std::uint64_t extra = 0) const
    {
        return of(m_request.settings.op, static_cast<std::uint64_t>(purpose), extra);
    }
    /// What a draw would be, whatever the operator.
    [[nodiscard]] OperatorResult drawn(DrawPurpose purpose, std::uint64_t extra = 0) const
    {
        return of(BrushOperator::Random, static_cast<std::uint64_t>(purpose), extra);
    }
    /// For purposes known by name: "scale.height".
    [[nodiscard]] OperatorResult of(BrushOperator op, std::string_view purpose,
                                    std::uint64_t extra = 0) const;
    /// Where they are seen, in the order of the request's ids.
    [[nodiscard]] std::span<const glm::vec3> positions() const;

private:
    [[nodiscard]] OperatorResult of(BrushOperator op, std::uint64_t purpose,
                                    std::uint64_t extra) const;

    const ChangeRequest& m_request;
    mutable std::vector<glm::vec3> m_positions; ///< once they have been asked for
};

/// Calls visit(i, row, id) for each of the request's individuals.
template<class Visit>
void forEachRow(const ChangeRequest& request, Visit&& visit)
{
    const Population& people = request.edit.scene().population;
    for (std::size_t i = 0; i < request.ids.size(); ++i) {
        visit(i, people.rowOf(request.ids[i]), request.ids[i]);
    }
}

/// Rows of the request's individuals, in their order.
[[nodiscard]] inline std::vector<std::size_t> rowsOf(const ChangeRequest& request)
{
    std::vector<std::size_t> rows(request.ids.size());
    forEachRow(request, [&rows](std::size_t i, std::size_t row, IndividualId) { rows[i] = row; });
    return rows;
}

[[nodiscard]] inline float valueAt(const ValueRange& range, double share)
{
    return range.low + (range.high - range.low) * static_cast<float>(share);
}

/// What a brush's change that stands in a header works with, since there the request is incomplete.
struct ChangeTools
{
    using Shares = OperatorShares;
    using Slots = ColourSlots;
    using Result = ChangeResult;
    using Reason = StrokeReason;
    template<class T>
    using Column = ColumnChange<T>;
    template<class Visit>
    static void forEachRow(const ChangeRequest& request, Visit&& visit)
    {
        model::forEachRow(request, std::forward<Visit>(visit));
    }
};

/// The range, as wide as it is, from another value on.
[[nodiscard]] inline ValueRange rangeFrom(float low, const ValueRange& range)
{
    return {low, low + range.high - range.low};
}

/// Lets the ranges that are on begin with what somebody has; says that.
template<class Settings>
std::string takeRanges(Settings& settings, const TakenFrom& from)
{
    std::string taken;
    for (const auto& range : Settings::columnRanges()) {
        if (settings.*range.isOn) {
            const float value = from.value(range.column);
            settings.*range.range = rangeFrom(value, settings.*range.range);
            taken += (taken.empty() ? "" : " · ") + shortNumber(static_cast<double>(value));
        }
    }
    return taken;
}

/// Writes the ranges that a brush's settings say, each by its own operator: see ColumnRange.
template<class Settings>
ChangeResult changeRanges(const ChangeRequest& request, const Settings& settings)
{
    const OperatorShares shares(request);
    const BrushSettings& brush = request.settings;
    ChangeResult result;
    bool hasValue = false;
    for (const auto& range : Settings::columnRanges()) {
        if (!(settings.*range.isOn)) {
            continue;
        }
        hasValue = true;
        const auto values = shares.of(settings.*range.op, range.draw).shares;
        const auto column = request.edit.scene().population.column(range.column);
        ColumnChange<float> change;
        forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId id) {
            const float target = valueAt(settings.*range.range, values[i]);
            change.set(id, column[row],
                       brush.buildUp ? column[row] + (target - column[row]) * brush.flow : target);
        });
        change.apply(request.edit, range.column, result.changed);
    }
    result.reason = hasValue ? StrokeReason::Unchanged : StrokeReason::NothingChosen;
    return result;
}

} // namespace crowd::model
