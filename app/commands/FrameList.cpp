// SPDX-License-Identifier: MIT
#include "app/commands/FrameList.h"

#include <algorithm>
#include <charconv>

namespace crowd::app {

namespace {

std::optional<int> wholeNumber(std::string_view digits)
{
    int value = 0;
    const char* end = digits.data() + digits.size();
    const auto [last, problem] = std::from_chars(digits.data(), end, value);
    return problem == std::errc() && last == end && value >= 0 ? std::optional(value)
                                                               : std::nullopt;
}

} // namespace

std::optional<FrameList::Range> FrameList::parsedRange(std::string_view text)
{
    const std::size_t times = text.find('x');
    const std::string_view span = text.substr(0, times);
    const std::size_t dash = span.find('-');
    const auto first = wholeNumber(span.substr(0, dash));
    const bool isOne = dash == std::string_view::npos;
    const auto last = isOne ? first : wholeNumber(span.substr(dash + 1));
    const bool isStepped = times != std::string_view::npos;
    const auto step = isStepped ? wholeNumber(text.substr(times + 1)) : std::optional(1);
    if (!first || !last || !step || *last < *first || *step < 1 || (isOne && isStepped)) {
        return std::nullopt;
    }
    return Range{*first, *last - (*last - *first) % *step, *step};
}

std::optional<FrameList> FrameList::parsed(std::string_view text)
{
    FrameList list;
    list.m_ranges.clear();
    while (true) {
        const std::size_t comma = text.find(',');
        const auto range = parsedRange(text.substr(0, comma));
        if (!range) {
            return std::nullopt;
        }
        list.m_ranges.push_back(*range);
        if (comma == std::string_view::npos) {
            return list;
        }
        text.remove_prefix(comma + 1);
    }
}

int FrameList::first() const
{
    return std::ranges::min(m_ranges, {}, &Range::first).first;
}

int FrameList::last() const
{
    return std::ranges::max(m_ranges, {}, &Range::last).last;
}

std::optional<int> FrameList::after(int frame) const
{
    std::optional<int> next;
    for (const Range& range : m_ranges) {
        if (range.last <= frame) {
            continue;
        }
        const int steps = frame < range.first ? 0 : (frame - range.first) / range.step + 1;
        const int candidate = range.first + steps * range.step;
        next = std::min(next.value_or(candidate), candidate);
    }
    return next;
}

} // namespace crowd::app
