// SPDX-License-Identifier: MIT
#include "behavior/rules/FiringLog.h"

#include <algorithm>
#include <utility>

#include "behavior/base/Agents.h"

namespace crowd::behavior {

namespace {

constexpr std::size_t kMaxEntries = 16'384;
constexpr double kHighlightSeconds = 0.5;
constexpr double kNotHighlighted = -1.0;

} // namespace

void FiringLog::add(const RuleFired& fired, std::uint32_t agent)
{
    ++m_counts[fired.rule];
    if (m_highlightedUntil[agent] < 0.0) {
        m_highlighted.push_back(agent);
    }
    m_highlightedUntil[agent] = fired.seconds + kHighlightSeconds;
    if (m_entries.size() < kMaxEntries) {
        m_entries.push_back(fired);
    }
}

void FiringLog::update(double now)
{
    std::erase_if(m_highlighted, [this, now](std::uint32_t agent) {
        const bool isOver = m_highlightedUntil[agent] <= now;
        m_highlightedUntil[agent] = isOver ? kNotHighlighted : m_highlightedUntil[agent];
        return isOver;
    });
}

void FiringLog::setPeople(std::span<const std::uint32_t> keep)
{
    rearrange(m_highlightedUntil, keep, kNotHighlighted);
    m_highlighted.clear();
    for (std::uint32_t agent = 0; agent < m_highlightedUntil.size(); ++agent) {
        if (m_highlightedUntil[agent] >= 0.0) {
            m_highlighted.push_back(agent);
        }
    }
}

std::uint64_t FiringLog::count(model::RuleId rule) const
{
    const auto found = m_counts.find(rule);
    return found == m_counts.end() ? 0 : found->second;
}

std::vector<RuleFired> FiringLog::take()
{
    return std::exchange(m_entries, {});
}

std::vector<std::uint32_t> FiringLog::highlighted() const
{
    std::vector<std::uint32_t> agents = m_highlighted;
    std::ranges::sort(agents);
    return agents;
}

} // namespace crowd::behavior
