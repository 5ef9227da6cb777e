// SPDX-License-Identifier: MIT
#include "behavior/session/RunJournal.h"

#include <algorithm>
#include <utility>

namespace crowd::behavior {

namespace {

constexpr std::size_t kMostJournalBytes = 256U << 20U;
constexpr std::size_t kActBytes = 256;         ///< about, of one without a scene
constexpr std::size_t kSceneBytes = 1U << 14U; ///< about, of one besides its people

/// What the second holds of its own.
std::size_t newBytes(const model::Population& before, const model::Population& after)
{
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < model::kColumnCount; ++i) {
        const auto column = static_cast<model::ColumnId>(i);
        const auto mine = after.columnBytes(column);
        bytes += mine.data() == before.columnBytes(column).data() ? 0 : mine.size();
    }
    return bytes;
}

} // namespace

RunJournal::RunJournal(const model::Scene& scene, double startSeconds,
                       std::shared_ptr<const WalkSurface> surface,
                       std::optional<RunBeginning> beginning)
    : m_scene(std::make_shared<const model::Scene>(scene)), m_startSeconds(startSeconds),
      m_surface(std::move(surface)), m_beginning(std::move(beginning)),
      m_lastPeople(scene.population)
{
}

void RunJournal::add(std::uint64_t step, Act act)
{
    keep({step, std::move(act), kActBytes});
}

void RunJournal::add(std::uint64_t step, Act act, const model::Scene& scene)
{
    keep({step, std::move(act), kSceneBytes + newBytes(m_lastPeople, scene.population)});
    m_lastPeople = scene.population;
}

void RunJournal::keep(Entry entry)
{
    if (m_isWhole) {
        m_bytes += entry.bytes;
        m_entries.push_back(std::move(entry));
    }
}

void RunJournal::limit()
{
    if (m_bytes > kMostJournalBytes) {
        m_isWhole = false;
        m_bytes = 0;
        m_entries.clear();
        m_lastPeople = {};
    }
}

void RunJournal::forgetFrom(std::uint64_t step)
{
    while (!m_entries.empty() && m_entries.back().step >= step) {
        m_bytes -= m_entries.back().bytes;
        m_entries.pop_back();
    }
}

std::unique_ptr<Session> RunJournal::begin() const
{
    auto session = std::make_unique<Session>(*m_scene);
    session->setStart(m_startSeconds);
    if (m_surface) {
        session->setSurface(m_surface);
    }
    if (m_beginning) {
        session->beginFrom(*m_beginning->before, *m_beginning->now);
    }
    return session;
}

void RunJournal::tell(Session& session) const
{
    const std::uint64_t step = session.steps();
    auto entry = std::ranges::lower_bound(m_entries, step, {}, &Entry::step);
    for (; entry != m_entries.end() && entry->step == step; ++entry) {
        entry->act(session);
    }
}

} // namespace crowd::behavior
