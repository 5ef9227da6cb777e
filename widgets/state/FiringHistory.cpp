// SPDX-License-Identifier: MIT
#include "widgets/state/FiringHistory.h"

#include <algorithm>
#include <cstddef>

namespace crowd::widgets {

namespace {

constexpr std::size_t kMostFired = 2'000'000; ///< 32 MB
constexpr std::size_t kForgotten = kMostFired / 4;

} // namespace

void FiringHistory::add(const std::vector<behavior::RuleFired>& fired, double startSeconds)
{
    for (behavior::RuleFired each : fired) {
        each.seconds += startSeconds;
        m_fired.push_back(each);
    }
    if (m_fired.size() > kMostFired) {
        const std::size_t forgotten = m_fired.size() - kMostFired + kForgotten;
        m_fired.erase(m_fired.begin(), m_fired.begin() + static_cast<std::ptrdiff_t>(forgotten));
        m_begin += forgotten;
    }
}

void FiringHistory::clear()
{
    m_begin = end();
    m_fired.clear();
}

void FiringHistory::forgetAfter(double seconds)
{
    m_begin = end() + 1; // so that whoever has seen all of it reads it again
    const auto first =
        std::ranges::upper_bound(m_fired, seconds, {}, &behavior::RuleFired::seconds);
    m_fired.erase(first, m_fired.end());
}

std::span<const behavior::RuleFired> FiringHistory::since(std::uint64_t number) const
{
    const std::uint64_t from = std::clamp(number, m_begin, end()) - m_begin;
    return std::span(m_fired).subspan(static_cast<std::size_t>(from));
}

} // namespace crowd::widgets
