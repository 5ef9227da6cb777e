// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "behavior/session/Session.h"
#include "model/brush/ClipChoice.h"

/// How people sit down and stand up while a session runs.
namespace crowd::behavior {

namespace {

constexpr float kSettlesWithin = 0.9F;  ///< metres of the seat: the rest goes past the others
constexpr float kSqueezesWithin = 4.0F; ///< who cannot get on does so from here
constexpr float kSettleSpeed = 0.9F;    ///< m/s
constexpr float kBlockedBelow = 0.15F;  ///< m/s
constexpr float kBlockedSeconds = 2.0F;
constexpr float kGivesUpSeconds = 15.0F;
constexpr float kTurnsToSeatWithin = 0.4F;

float awayFrom(const glm::vec3& a, const glm::vec3& b)
{
    const float x = a.x - b.x;
    const float z = a.z - b.z;
    return std::sqrt(x * x + z * z);
}

} // namespace

const model::TemplateEntry* Session::entryOf(const Shown& shown) const
{
    return shown.table < m_templates->size() ? &(*m_templates)[shown.table] : nullptr;
}

/// As the clip column counts; -1: there is none of that name.
int Session::clipNamed(const Shown& shown, const char* name) const
{
    const model::TemplateEntry* entry = entryOf(shown);
    if (entry == nullptr) {
        return -1;
    }
    const auto found = std::ranges::find(entry->clipNames, name);
    return found == entry->clipNames.end() ? -1
                                           : static_cast<int>(found - entry->clipNames.begin());
}

const model::Seat* Session::seatOf(model::SeatId id) const
{
    const auto found = std::ranges::lower_bound(m_seats, id, {}, &model::WorldSeat::id);
    return found != m_seats.end() && found->id == id ? &found->seat : nullptr;
}

/// All seats, and which of them are taken.
void Session::readSeats()
{
    model::Scene stages;
    stages.stages = m_stages;
    m_seats = stages.worldSeats();
    m_isSeatTaken.assign(m_seats.size(), false);
    for (const Shown& shown : m_shown) {
        const auto found = std::ranges::lower_bound(m_seats, shown.seat, {}, &model::WorldSeat::id);
        if (!shown.isGone && found != m_seats.end() && found->id == shown.seat) {
            m_isSeatTaken[static_cast<std::size_t>(found - m_seats.begin())] = true;
        }
    }
}

bool Session::hasSeats()
{
    if (m_seats.empty()) {
        readSeats();
    }
    return !m_seats.empty();
}

bool Session::sit(std::uint32_t agent, float metres)
{
    if (m_seats.empty()) {
        readSeats();
    }
    const glm::vec3 at = m_motion.position(agent);
    std::size_t best = m_seats.size();
    float nearest = metres > 0.0F ? metres : 1e30F;
    for (std::size_t i = 0; i < m_seats.size(); ++i) {
        const float away = glm::distance(m_seats[i].seat.position, at);
        if (!m_isSeatTaken[i] && away < nearest) {
            nearest = away;
            best = i;
        }
    }
    if (best == m_seats.size()) {
        return false;
    }
    m_isSeatTaken[best] = true;
    m_follower.sendTo(agent, m_seats[best].seat.position, 0.0F);
    Shown& shown = activate(agent);
    shown.seat = m_seats[best].id;
    shown.sitting = Sitting::Goes;
    shown.blockedSeconds = 0.0F;
    m_hasSat = true;
    m_sitters.insert(std::ranges::upper_bound(m_sitters, agent), agent);
    return true;
}

bool Session::isSittingDown(std::uint32_t agent) const
{
    return m_shown[agent].sitting == Sitting::Goes || m_shown[agent].sitting == Sitting::Settles;
}

/// A step of somebody on the way to a seat.
void Session::settle(std::uint32_t agent)
{
    Shown& shown = markDirty(agent);
    const model::Seat* seat = seatOf(shown.seat);
    if (seat == nullptr && m_seats.empty()) {
        readSeats();
        seat = seatOf(shown.seat);
    }
    if (seat == nullptr) {
        leaveSeat(agent); // its stage is gone
        return;
    }
    const glm::vec3 at = m_motion.position(agent);
    const float away = awayFrom(seat->position, at);
    if (shown.sitting == Sitting::Goes) {
        shown.blockedSeconds =
            m_motion.speed[agent] < kBlockedBelow ? shown.blockedSeconds + m_stepSeconds : 0.0F;
        const bool isThere = away < kSettlesWithin ||
                             (shown.blockedSeconds > kBlockedSeconds && away < kSqueezesWithin);
        if (isThere) {
            shown.sitting = Sitting::Settles;
            m_follower.stop(agent);
        } else if (shown.blockedSeconds > kGivesUpSeconds) {
            leaveSeat(agent);
        }
        return;
    }
    const float reach = kSettleSpeed * m_stepSeconds;
    const glm::vec3 way = seat->position - at;
    const float length = glm::length(way);
    m_motion.speed[agent] = kSettleSpeed;
    if (length > reach) {
        m_motion.put(agent, at + way * (reach / length));
        m_motion.heading[agent] =
            turnedTo(m_motion.heading[agent],
                     away > kTurnsToSeatWithin ? std::atan2(way.x, way.z) : seat->headingRadians);
        return;
    }
    m_motion.put(agent, seat->position);
    takeSeat(agent);
}

void Session::takeSeat(std::uint32_t agent)
{
    Shown& shown = markDirty(agent);
    shown.sitting = Sitting::Sits;
    m_motion.speed[agent] = 0.0F;
    shown.gait = 0;
    shown.facing = seatOf(shown.seat)->headingRadians;
    shown.isTurning = true;
    const model::TemplateEntry* entry = entryOf(shown);
    if (entry != nullptr && entry->asset) {
        setBase(agent, model::usualClip(*entry, true));
    }
    shown.order = clipNamed(shown, "sit_down");
    shown.isOrderLooped = false;
    shown.isOrderOwn = true;
    shown.orderPlace = 0.0;
    std::erase(m_sitters, agent);
}

float Session::standUp(std::uint32_t agent)
{
    Shown& shown = activate(agent);
    shown.order = clipNamed(shown, "stand_up");
    shown.isOrderLooped = false;
    shown.isOrderOwn = false;
    shown.orderPlace = 0.0;
    const ClipFacts* facts = clipFacts(shown, shown.order);
    return facts != nullptr ? facts->seconds : 0.0F;
}

void Session::leaveSeat(std::uint32_t agent)
{
    Shown& shown = m_shown[agent];
    if (shown.seat == model::kNoSeat) {
        return;
    }
    const auto found = std::ranges::lower_bound(m_seats, shown.seat, {}, &model::WorldSeat::id);
    if (found != m_seats.end() && found->id == shown.seat) {
        m_isSeatTaken[static_cast<std::size_t>(found - m_seats.begin())] = false;
    }
    const bool didSit = isSeated(agent);
    shown.seat = model::kNoSeat;
    shown.sitting = Sitting::No;
    activate(agent);
    m_hasSat = true;
    std::erase(m_sitters, agent);
    const model::TemplateEntry* entry = entryOf(shown);
    if (didSit && entry != nullptr && entry->asset) {
        setBase(agent, model::usualClip(*entry, false));
        shown.order = -1;
    }
}

} // namespace crowd::behavior
