// SPDX-License-Identifier: MIT
#include "render/crowd/CrowdPlan.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "model/base/Parallel.h"
#include "render/crowd/PlanLook.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr std::size_t kChunk = 4096;

/// Counts become the place of each key's first item.
void toStarts(std::vector<std::uint32_t>& counts)
{
    std::uint32_t sum = 0;
    for (std::uint32_t& count : counts) {
        sum += std::exchange(count, sum);
    }
}

} // namespace

/// Carries the levels over to the rows that the same individuals have now.
void CrowdPlan::keepLevels(const Population& population)
{
    const bool areRowsTheSame = population.rowsVersion() == m_lastPopulation.rowsVersion() &&
                                m_levels.size() == population.size();
    if (!areRowsTheSame) {
        std::vector<std::uint8_t> levels(population.size(), kNoLevel);
        const std::span<const IndividualId> before = m_lastPopulation.ids();
        const std::span<const IndividualId> now = population.ids();
        std::size_t old = 0;
        for (std::size_t row = 0; row < now.size() && !m_levels.empty(); ++row) {
            while (old < before.size() && before[old] < now[row]) {
                ++old;
            }
            if (old < before.size() && before[old] == now[row]) {
                levels[row] = m_levels[old];
            }
        }
        m_levels = std::move(levels);
    }
    m_lastPopulation = population;
}

void CrowdPlan::mark(const Request& request)
{
    const std::span<const IndividualId> ids = request.frame.population.ids();
    m_flags.assign(ids.size(), 0);
    std::size_t row = 0;
    for (const IndividualId id : request.selected) {
        while (row < ids.size() && ids[row] < id) {
            ++row;
        }
        if (row < ids.size() && ids[row] == id) {
            m_flags[row] = Instance::kSelected >> 24U;
        }
    }
    const std::size_t hovered = request.frame.population.rowOf(request.hovered);
    if (hovered != Population::npos) {
        m_flags[hovered] |= static_cast<std::uint8_t>(Instance::kHovered >> 24U);
    }
}

void CrowdPlan::look(const Request& request)
{
    const PlanLook look(request);
    const std::size_t count = request.frame.population.size();
    m_seen.resize((count + kChunk - 1) / kChunk);
    parallelFor(count, kChunk, [&](std::size_t begin, std::size_t end) {
        PlanSeen& seen = m_seen[begin / kChunk];
        seen.instances.resize(kChunk);
        seen.keys.resize(kChunk);
        seen.count = 0;
        seen.isMissing = false;
        seen.wanted.assign(look.courses(), 0);
        look.rows(begin, end, m_levels, m_flags, seen);
    });
    m_orderEnd = look.orderEnd();
    m_areKeyframesMissing = std::ranges::any_of(m_seen, &PlanSeen::isMissing);
    m_wanted.clear();
    std::vector<std::uint8_t> wanted(look.courses(), 0);
    for (const PlanSeen& seen : m_seen) {
        std::ranges::transform(wanted, seen.wanted, wanted.begin(), std::bit_or<std::uint8_t>());
    }
    look.list(wanted, m_wanted);
}

/// The first of two stable counting sorts.
void CrowdPlan::sortByKeyframe()
{
    m_counts.assign(m_orderEnd, 0);
    std::size_t count = 0;
    for (const PlanSeen& seen : m_seen) {
        for (std::size_t i = 0; i < seen.count; ++i) {
            ++m_counts[seen.keys[i].keyframe];
        }
        count += seen.count;
    }
    toStarts(m_counts);
    m_byKeyframe.resize(count);
    for (std::size_t chunk = 0; chunk < m_seen.size(); ++chunk) {
        const PlanSeen& seen = m_seen[chunk];
        for (std::size_t i = 0; i < seen.count; ++i) {
            m_byKeyframe[m_counts[seen.keys[i].keyframe]++] = {
                static_cast<std::uint32_t>(chunk * kChunk + i), seen.keys[i].group};
        }
    }
}

/// The second, by what decides more. Moves places about, not instances.
void CrowdPlan::sortByGroup(std::size_t entries)
{
    m_counts.assign(entries * kDrawnLevels * kDistanceSteps, 0);
    for (const Key& key : m_byKeyframe) {
        ++m_counts[key.group];
    }
    toStarts(m_counts);
    m_places.resize(m_byKeyframe.size());
    for (const Key& key : m_byKeyframe) {
        m_places[m_counts[key.group]++] = key.place;
    }
}

void CrowdPlan::placeSorted()
{
    m_instances.resize(m_places.size());
    parallelFor(m_places.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t place = m_places[i];
            m_instances[i] = m_seen[place / kChunk].instances[place % kChunk];
        }
    });
}

/// After sorting, m_counts holds the end of each group.
void CrowdPlan::makeRuns(std::size_t entries)
{
    m_runs.clear();
    m_byLevel = {};
    std::size_t first = 0;
    for (std::size_t run = 0; run < entries * kDrawnLevels; ++run) {
        const std::size_t end = m_counts[(run + 1) * kDistanceSteps - 1];
        if (end > first) {
            const std::size_t level = run / entries;
            m_runs.push_back(
                {static_cast<int>(run % entries), static_cast<int>(level), first, end - first});
            m_byLevel[level] += static_cast<int>(end - first);
        }
        first = end;
    }
}

void CrowdPlan::collectHighlighted()
{
    m_highlighted.clear();
    m_highlightedRuns.clear();
    for (const InstanceRun& run : m_runs) {
        InstanceRun marked{run.entry, run.level, m_highlighted.size(), 0};
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            if ((m_instances[i].rowAndFlags & (Instance::kSelected | Instance::kHovered)) != 0) {
                m_highlighted.push_back(m_instances[i]);
            }
        }
        marked.count = m_highlighted.size() - marked.first;
        if (marked.count > 0) {
            m_highlightedRuns.push_back(marked);
        }
    }
}

void CrowdPlan::make(const Request& request)
{
    keepLevels(request.frame.population);
    mark(request);
    look(request);
    sortByKeyframe();
    sortByGroup(request.templates.size());
    makeRuns(request.templates.size());
    placeSorted();
    if (!request.selected.empty() || request.hovered != 0) {
        collectHighlighted();
    } else {
        m_highlighted.clear();
        m_highlightedRuns.clear();
    }
}

} // namespace crowd::render
