// SPDX-License-Identifier: MIT
#include "behavior/agents/IdleClips.h"

#include <cmath>

namespace crowd::behavior {

namespace {

namespace idleKeys = model::columns;

} // namespace

std::uint16_t IdleClips::clip(std::uint32_t agent) const
{
    const int own = m_states[agent].clip;
    return own >= 0 ? static_cast<std::uint16_t>(own) : m_people.column(idleKeys::clip)[agent];
}

float IdleClips::rate(std::uint32_t agent) const
{
    return m_states[agent].rate.value_or(m_people.column(idleKeys::playbackSpeed)[agent]);
}

double IdleClips::phase(std::uint32_t agent) const
{
    return m_states[agent].phase.value_or(
        static_cast<double>(m_people.column(idleKeys::phase)[agent]));
}

double IdleClips::place(std::uint32_t agent) const
{
    const TemplateTables::ClipFacts* facts = m_templates.clip(m_agents.table[agent], clip(agent));
    const double passed = facts != nullptr && facts->seconds > 0.0F
                              ? m_clock.seconds() * static_cast<double>(rate(agent)) /
                                    static_cast<double>(facts->seconds)
                              : 0.0;
    return passed + phase(agent);
}

void IdleClips::setPlace(std::uint32_t agent, double wanted)
{
    m_agents.markDirty(agent);
    State& state = m_states[agent];
    state.phase = 0.0;
    const double phase = wanted - place(agent);
    state.phase = phase - std::floor(phase);
    m_overrides.set(idleKeys::phase, m_people.ids()[agent], static_cast<float>(*state.phase));
}

void IdleClips::setPhase(std::uint32_t agent, float phase)
{
    m_agents.markDirty(agent);
    m_states[agent].phase = static_cast<double>(phase);
    m_overrides.set(idleKeys::phase, m_people.ids()[agent], phase);
}

void IdleClips::resumeClip(std::uint32_t agent, std::uint16_t clip)
{
    m_agents.markDirty(agent);
    m_states[agent].clip = clip;
    m_overrides.set(idleKeys::clip, m_people.ids()[agent], clip);
}

void IdleClips::setRate(std::uint32_t agent, float rate)
{
    const double now = place(agent);
    m_states[agent].rate = rate;
    m_overrides.set(idleKeys::playbackSpeed, m_people.ids()[agent], rate);
    setPlace(agent, now);
}

void IdleClips::setPosture(std::uint32_t agent, int clip)
{
    m_agents.markDirty(agent);
    m_states[agent].clip = clip;
    m_overrides.forget(idleKeys::clip.id, m_people.ids()[agent]);
}

void IdleClips::setClip(std::uint32_t agent, std::string_view name)
{
    m_agents.markDirty(agent);
    const int named = m_templates.clipNamed(m_agents.table[agent], name);
    if (named < 0 || named == static_cast<int>(clip(agent))) {
        return;
    }
    m_states[agent].clip = named;
    m_overrides.set(idleKeys::clip, m_people.ids()[agent], static_cast<std::uint16_t>(named));
    setPlace(agent, 0.0);
}

void IdleClips::forget(std::uint32_t agent, model::ColumnId column)
{
    const bool isForgotten = m_overrides.forget(column, m_people.ids()[agent]);
    State& state = m_states[agent];
    if (column == idleKeys::clip.id && isForgotten) {
        state.clip = -1;
    } else if (column == idleKeys::phase.id) {
        state.phase.reset();
    } else if (column == idleKeys::playbackSpeed.id) {
        state.rate.reset();
    }
}

} // namespace crowd::behavior
