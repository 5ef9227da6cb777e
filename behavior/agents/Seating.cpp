// SPDX-License-Identifier: MIT
#include "behavior/agents/Seating.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "behavior/agents/Turning.h"
#include "model/brush/ClipChoice.h"

namespace crowd::behavior {

namespace {

constexpr float kSettlesWithin = 0.9F;  ///< metres of the seat: the rest goes past the others
constexpr float kSqueezesWithin = 4.0F; ///< metres: who cannot get on settles from here
constexpr float kSettleSpeed = 0.9F;    ///< m/s
constexpr float kBlockedBelow = 0.15F;  ///< m/s
constexpr float kBlockedSeconds = 2.0F;
constexpr float kGivesUpSeconds = 15.0F;
constexpr float kTurnsToSeatWithin = 0.4F; ///< metres

float metresOnGround(const glm::vec3& a, const glm::vec3& b)
{
    const float x = a.x - b.x;
    const float z = a.z - b.z;
    return std::sqrt(x * x + z * z);
}

} // namespace

void Seating::rearrange(std::span<const std::uint32_t> keep)
{
    behavior::rearrange(m_states, keep);
    m_sitters.clear();
    for (std::uint32_t agent = 0; agent < m_states.size(); ++agent) {
        if (m_agents.isOnWayToSeat(agent)) {
            m_sitters.push_back(agent);
        }
    }
}

void Seating::setStages(std::vector<model::StageEntry> stages)
{
    m_stages = std::move(stages);
    m_seats.clear();
}

void Seating::setSeat(std::uint32_t agent, model::SeatId seat, bool keepsPhase)
{
    m_states[agent].seat = seat;
    if (!keepsPhase) {
        m_agents.seatPhase[agent] = SeatPhase::None;
    }
}

void Seating::resume(std::uint32_t agent, model::SeatId seat)
{
    if (seat == m_states[agent].seat) {
        return;
    }
    m_states[agent].seat = seat;
    m_agents.seatPhase[agent] = seat != model::kNoSeat ? SeatPhase::Seated : SeatPhase::None;
    m_hasChanged = true;
}

std::size_t Seating::indexOf(model::SeatId seat) const
{
    const auto found = std::ranges::lower_bound(m_seats, seat, {}, &model::WorldSeat::id);
    return found != m_seats.end() && found->id == seat
               ? static_cast<std::size_t>(found - m_seats.begin())
               : m_seats.size();
}

/// All seats, and which of them are taken.
void Seating::readSeats()
{
    model::Scene stages;
    stages.stages = m_stages;
    m_seats = stages.worldSeats();
    m_isTaken.assign(m_seats.size(), false);
    for (std::uint32_t agent = 0; agent < m_states.size(); ++agent) {
        const std::size_t seat = indexOf(m_states[agent].seat);
        if (m_agents.isGone[agent] == 0 && seat < m_seats.size()) {
            m_isTaken[seat] = true;
        }
    }
}

bool Seating::hasSeats()
{
    if (m_seats.empty()) {
        readSeats();
    }
    return !m_seats.empty();
}

bool Seating::sit(std::uint32_t agent, float metres)
{
    if (m_seats.empty()) {
        readSeats();
    }
    const glm::vec3 at = m_agents.motion.position(agent);
    std::size_t best = m_seats.size();
    float nearest = metres > 0.0F ? metres : 1e30F;
    for (std::size_t i = 0; i < m_seats.size(); ++i) {
        const float away = glm::distance(m_seats[i].seat.position, at);
        if (!m_isTaken[i] && away < nearest) {
            nearest = away;
            best = i;
        }
    }
    if (best == m_seats.size()) {
        return false;
    }
    m_isTaken[best] = true;
    m_follower.sendTo(agent, m_seats[best].seat.position, 0.0F);
    m_agents.activate(agent);
    m_agents.seatPhase[agent] = SeatPhase::Approaching;
    m_states[agent] = {m_seats[best].id, 0.0F};
    m_hasChanged = true;
    m_sitters.insert(std::ranges::upper_bound(m_sitters, agent), agent);
    return true;
}

bool Seating::isSeated(std::uint32_t agent) const
{
    return m_states[agent].seat != model::kNoSeat && !m_agents.isOnWayToSeat(agent);
}

model::SeatId Seating::shownSeat(std::uint32_t agent) const
{
    return m_agents.isOnWayToSeat(agent) ? model::kNoSeat : m_states[agent].seat;
}

void Seating::step()
{
    const std::vector<std::uint32_t> sitters = m_sitters; // some of them arrive or give up
    for (const std::uint32_t agent : sitters) {
        stepOne(agent);
    }
}

void Seating::stepOne(std::uint32_t agent)
{
    m_agents.markDirty(agent);
    if (m_seats.empty()) {
        readSeats();
    }
    const std::size_t index = indexOf(m_states[agent].seat);
    if (index == m_seats.size()) {
        leaveSeat(agent); // its stage is gone
        return;
    }
    const model::Seat& seat = m_seats[index].seat;
    if (m_agents.seatPhase[agent] == SeatPhase::Approaching) {
        approach(agent, metresOnGround(seat.position, m_agents.motion.position(agent)));
    } else {
        settle(agent, seat);
    }
}

void Seating::approach(std::uint32_t agent, float metresAway)
{
    State& state = m_states[agent];
    state.blockedSeconds = m_agents.motion.speed[agent] < kBlockedBelow
                               ? state.blockedSeconds + m_clock.stepSeconds
                               : 0.0F;
    const bool isThere = metresAway < kSettlesWithin ||
                         (state.blockedSeconds > kBlockedSeconds && metresAway < kSqueezesWithin);
    if (isThere) {
        m_agents.seatPhase[agent] = SeatPhase::Settling;
        m_follower.stop(agent);
    } else if (state.blockedSeconds > kGivesUpSeconds) {
        leaveSeat(agent);
    }
}

/// Straight on to the seat, whoever sits in between.
void Seating::settle(std::uint32_t agent, const model::Seat& seat)
{
    MotionState& motion = m_agents.motion;
    const float reach = kSettleSpeed * m_clock.stepSeconds;
    const glm::vec3 at = motion.position(agent);
    const glm::vec3 way = seat.position - at;
    const float length = glm::length(way);
    motion.speed[agent] = kSettleSpeed;
    if (length > reach) {
        const float away = metresOnGround(seat.position, at);
        motion.put(agent, at + way * (reach / length));
        motion.heading[agent] = turnedTowards(motion.heading[agent],
                                              away > kTurnsToSeatWithin ? std::atan2(way.x, way.z)
                                                                        : seat.headingRadians,
                                              kTurnRadiansPerSecond * m_clock.stepSeconds);
        return;
    }
    motion.put(agent, seat.position);
    takeSeat(agent, seat);
}

/// The clip that the template has for sitting or standing.
void Seating::setPosture(std::uint32_t agent, bool isSeated)
{
    const model::TemplateEntry* entry = m_templates.entry(m_agents.table[agent]);
    if (entry != nullptr && entry->asset) {
        m_idle.setPosture(agent, model::usualClip(*entry, isSeated));
    }
}

void Seating::takeSeat(std::uint32_t agent, const model::Seat& seat)
{
    m_agents.seatPhase[agent] = SeatPhase::Seated;
    m_agents.motion.speed[agent] = 0.0F;
    m_agents.turnTo(agent, seat.headingRadians);
    m_animation.stand(agent);
    setPosture(agent, true);
    m_animation.playOnce(agent, m_templates.clipNamed(m_agents.table[agent], "sit_down"), true);
    std::erase(m_sitters, agent);
}

float Seating::standUp(std::uint32_t agent)
{
    m_agents.activate(agent);
    const std::uint32_t table = m_agents.table[agent];
    const int clip = m_templates.clipNamed(table, "stand_up");
    m_animation.playOnce(agent, clip, false);
    const TemplateTables::ClipFacts* facts = m_templates.clip(table, clip);
    return facts != nullptr ? facts->seconds : 0.0F;
}

void Seating::leaveSeat(std::uint32_t agent)
{
    State& state = m_states[agent];
    if (state.seat == model::kNoSeat) {
        return;
    }
    const std::size_t index = indexOf(state.seat);
    if (index < m_seats.size()) {
        m_isTaken[index] = false;
    }
    const bool didSit = isSeated(agent);
    state.seat = model::kNoSeat;
    m_agents.seatPhase[agent] = SeatPhase::None;
    m_agents.activate(agent);
    m_hasChanged = true;
    std::erase(m_sitters, agent);
    const model::TemplateEntry* entry = m_templates.entry(m_agents.table[agent]);
    if (didSit && entry != nullptr && entry->asset) {
        setPosture(agent, false);
        m_animation.endClip(agent);
    }
}

} // namespace crowd::behavior
