// SPDX-License-Identifier: MIT
#include "behavior/agents/StateFades.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <map>

#include "model/population/Properties.h"

namespace crowd::behavior {

using namespace model;

namespace {

namespace fadeKeys = model::columns;

std::span<const std::byte> bytesOf(const Population& people, ColumnId column, std::size_t row)
{
    const std::size_t stride = columnInfo(column).stride;
    return people.columnBytes(column).subspan(row * stride, stride);
}

bool differs(const Population& a, const Population& b, ColumnId column, std::size_t rowA,
             std::size_t rowB)
{
    const auto one = bytesOf(a, column, rowA);
    return std::memcmp(one.data(), bytesOf(b, column, rowB).data(), one.size()) != 0;
}

constexpr std::array kClipColumns{ColumnId::Clip, ColumnId::Phase, ColumnId::PlaybackSpeed};

/// The columns that go together with this one.
std::span<const ColumnId> togetherWith(const ColumnId& column)
{
    return column == ColumnId::Clip ? std::span<const ColumnId>(kClipColumns)
                                    : std::span(&column, 1);
}

bool differsInAny(const Population& a, const Population& b, ColumnId column, std::size_t rowA,
                  std::size_t rowB)
{
    return std::ranges::any_of(togetherWith(column),
                               [&](ColumnId each) { return differs(a, b, each, rowA, rowB); });
}

bool isShared(const Population& a, const Population& b, ColumnId column)
{
    return std::ranges::all_of(togetherWith(column), [&](ColumnId each) {
        return a.columnBytes(each).data() == b.columnBytes(each).data();
    });
}

/// Phase and speed go with the clip.
ColumnSet withClip(ColumnSet columns)
{
    if (std::ranges::any_of(kClipColumns,
                            [&columns](ColumnId each) { return columns.contains(each); })) {
        columns.insert(ColumnId::Clip);
    }
    return columns;
}

using Keep = std::function<bool(IndividualId)>;

/// Only those who are to be kept; null: nobody.
std::shared_ptr<const FadeColumn> only(const std::shared_ptr<const FadeColumn>& column,
                                       const Keep& isKept)
{
    const FadeTimes& times = *column->times;
    const std::size_t stride = columnInfo(column->column).stride;
    FadeColumn left{column->column, nullptr, {}, {}, {}};
    auto kept = std::make_shared<FadeTimes>();
    kept->seconds = times.seconds;
    for (std::size_t i = 0; i < times.ids.size(); ++i) {
        if (!isKept(times.ids[i])) {
            continue;
        }
        kept->ids.push_back(times.ids[i]);
        kept->begins.push_back(times.begins[i]);
        kept->areWhole.push_back(times.areWhole[i]);
        const auto value = column->bytes.begin() + static_cast<std::ptrdiff_t>(i * stride);
        left.bytes.insert(left.bytes.end(), value, value + static_cast<std::ptrdiff_t>(stride));
        if (column->column == ColumnId::Clip) {
            left.phases.push_back(column->phases[i]);
            left.rates.push_back(column->rates[i]);
        }
        kept->end = std::max(kept->end, times.begins[i] + times.seconds);
    }
    if (kept->ids.empty()) {
        return nullptr;
    }
    if (kept->ids.size() == times.ids.size()) {
        return column;
    }
    left.times = std::move(kept);
    return std::make_shared<const FadeColumn>(std::move(left));
}

FadeColumn columnFrom(const Population& before, ColumnId column,
                      const std::shared_ptr<const FadeTimes>& times)
{
    FadeColumn from{column, times, before.values(column, times->ids), {}, {}};
    for (std::size_t i = 0; i < times->ids.size() && column == ColumnId::Clip; ++i) {
        const std::size_t row = before.rowOf(times->ids[i]);
        from.phases.push_back(before.column(fadeKeys::phase)[row]);
        from.rates.push_back(before.column(fadeKeys::playbackSpeed)[row]);
    }
    return from;
}

/// Who differs in a column, and begins when.
class Beginning
{
public:
    Beginning(const ChangeOver& change, std::span<const float> delays, const Population& before,
              const Population& after, double seconds)
        : m_change(change), m_delays(delays), m_before(before), m_after(after), m_seconds(seconds)
    {
    }
    /// Null: nobody.
    [[nodiscard]] std::shared_ptr<const FadeTimes> timesOf(ColumnId column);

private:
    const ChangeOver& m_change;
    std::span<const float> m_delays;
    const Population& m_before;
    const Population& m_after;
    double m_seconds;
    /// Mostly the same people differ in several columns.
    std::vector<std::shared_ptr<const FadeTimes>> m_known;
};

std::shared_ptr<const FadeTimes> Beginning::timesOf(ColumnId column)
{
    FadeTimes times;
    times.seconds = static_cast<double>(m_change.timing.seconds);
    if (isShared(m_before, m_after, column)) {
        return nullptr;
    }
    for (std::size_t i = 0; i < m_change.ids.size(); ++i) {
        const IndividualId id = m_change.ids[i];
        const std::size_t then = m_before.rowOf(id);
        const std::size_t now = m_after.rowOf(id);
        if (then == Population::npos || now == Population::npos ||
            !differsInAny(m_before, m_after, column, then, now)) {
            continue;
        }
        const bool isWhole = differs(m_before, m_after, ColumnId::Template, then, now);
        times.ids.push_back(id);
        times.begins.push_back(m_seconds + static_cast<double>(m_delays[i]));
        times.areWhole.push_back(isWhole ? 1 : 0);
        times.end = std::max(times.end, times.begins.back() + times.seconds);
    }
    if (times.ids.empty()) {
        return nullptr;
    }
    const auto same = std::ranges::find_if(
        m_known, [&times](const auto& known) { return known->ids == times.ids; });
    if (same != m_known.end()) {
        return *same;
    }
    return m_known.emplace_back(std::make_shared<const FadeTimes>(std::move(times)));
}

} // namespace

void StateFades::add(FadeColumn column)
{
    FadeColumns all = m_shown ? *m_shown : FadeColumns();
    all.push_back(std::make_shared<const FadeColumn>(std::move(column)));
    m_shown = std::make_shared<const FadeColumns>(std::move(all));
}

void StateFades::begin(const ChangeOver& change, std::span<const float> delays,
                       const Population& before, const Population& after, double seconds)
{
    if (change.timing.isAtOnce()) {
        return;
    }
    const ColumnSet columns = withClip(change.columns);
    Beginning beginning(change, delays, before, after, seconds);
    columns.forEach([&](ColumnId column) {
        const bool isWithClip = column == ColumnId::Phase || column == ColumnId::PlaybackSpeed;
        if (const auto times = isWithClip ? nullptr : beginning.timesOf(column)) {
            add(columnFrom(before, column, times));
        }
    });
}

void StateFades::forget(const ChangeOver& change)
{
    const ColumnSet columns = withClip(change.columns);
    FadeColumns all;
    for (const auto& each : m_shown ? *m_shown : FadeColumns()) {
        const auto left =
            !columns.contains(each->column) ? each : only(each, [&change](IndividualId id) {
                return !std::ranges::binary_search(change.ids, id);
            });
        if (left) {
            all.push_back(left);
        }
    }
    m_shown = all.empty() ? nullptr : std::make_shared<const FadeColumns>(std::move(all));
}

void StateFades::forgetEdited(const Population& before, const Population& now)
{
    if (!m_shown) {
        return;
    }
    FadeColumns all;
    for (const auto& each : *m_shown) {
        const auto left =
            isShared(before, now, each->column) ? each : only(each, [&](IndividualId id) {
                const std::size_t then = before.rowOf(id);
                const std::size_t row = now.rowOf(id);
                return then != Population::npos && row != Population::npos &&
                       !differsInAny(before, now, each->column, then, row);
            });
        if (left) {
            all.push_back(left);
        }
    }
    m_shown = all.empty() ? nullptr : std::make_shared<const FadeColumns>(std::move(all));
}

void StateFades::end(double seconds)
{
    const auto isOver = [seconds](const auto& each) { return each->times->end <= seconds; };
    if (!m_shown || std::ranges::none_of(*m_shown, isOver)) {
        return;
    }
    FadeColumns left = *m_shown;
    std::erase_if(left, isOver);
    m_shown = left.empty() ? nullptr : std::make_shared<const FadeColumns>(std::move(left));
}

} // namespace crowd::behavior
