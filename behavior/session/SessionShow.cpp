// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "behavior/crowd/Chunks.h"
#include "behavior/session/Session.h"
#include "behavior/surface/WalkSurface.h"

/// What a session shows of people: body, heading, gait and clip.
namespace crowd::behavior {

namespace {

constexpr float kTurnRadiansPerSecond = 4.0F;
constexpr float kTurnsAbove = 0.15F; ///< m/s: below, nobody turns to where he is pushed
constexpr float kMovesAbove = 0.02F;
constexpr float kRunsAbove = 2.0F;      ///< m/s
constexpr float kFastestStride = 12.0F; ///< m/s: faster is no walk but a jump
constexpr float kLiftSeconds = 0.15F;   ///< so long before a step up feet are lifted
constexpr float kSameHeight = 0.001F;   ///< metres

} // namespace

/// Angle after turning towards another one as far as a body can in one step.
float Session::turnedTo(float heading, float target) const
{
    float turn = wrappedRadians(target - heading);
    const float most = kTurnRadiansPerSecond * m_stepSeconds;
    turn = std::clamp(turn, -most, most);
    return wrappedRadians(heading + turn);
}

const Session::ClipFacts* Session::clipFacts(const Shown& shown, int clip) const
{
    if (shown.table >= m_clips.size() || clip < 0 ||
        static_cast<std::size_t>(clip) >= m_clips[shown.table].size()) {
        return nullptr;
    }
    return &m_clips[shown.table][static_cast<std::size_t>(clip)];
}

Session::Shown& Session::markDirty(std::uint32_t agent)
{
    m_motion.mode[agent] = static_cast<std::int32_t>(UpdateMode::Full);
    return m_shown[agent];
}

Session::Shown& Session::activate(std::uint32_t agent)
{
    m_motion.flags[agent] |= kPoseLive;
    return markDirty(agent);
}

bool Session::isLive(std::uint32_t agent) const
{
    return (m_motion.flags[agent] & kPoseLive) != 0;
}

/// Whoever does not want to go further comes to rest in a step or two rather than at once.
void Session::brake()
{
    const std::span<Body> bodies = m_crowd.bodies();
    overRows(bodies.size(), [this, bodies](std::size_t begin, std::size_t end) {
        for (std::size_t agent = begin; agent < end; ++agent) {
            Body& body = bodies[agent];
            if (body.preferredSpeed != 0.0F) {
                continue;
            }
            const float speed =
                std::sqrt(body.velocityX * body.velocityX + body.velocityZ * body.velocityZ);
            if (speed < kMovesAbove) {
                continue;
            }
            const Shown& shown = m_shown[agent];
            if (shown.isGone || shown.isPut || shown.sitting != Sitting::No ||
                shown.table >= m_gaits.size() || m_gaits[shown.table].isEmpty()) {
                continue;
            }
            const GaitTable::Gait& gait = m_gaits[shown.table].gait(shown.gait);
            const auto place = static_cast<double>(m_motion.gaitPlace[agent]);
            body.preferredSpeed = -GaitTable::braking(gait, place, speed, shown.height);
        }
    });
}

/// MotionState after a step: of many at once, and by themselves of those to whom something happens.
void Session::showAll()
{
    overRows(m_shown.size(), [this](std::size_t begin, std::size_t end) {
        for (std::size_t first = begin; first < end; first += kStrideBlock) {
            follow(first, std::min(first + kStrideBlock, end));
        }
    });
}

/// The height of the ground where somebody's feet will be as he has come up to it: before a step
/// up he lifts them, down a step he goes once he is over it.
float Session::groundAhead(const Body& body, float height, float surfaceHeight) const
{
    const float ahead = m_surface->underfoot(body.x + body.velocityX * kLiftSeconds,
                                             body.z + body.velocityZ * kLiftSeconds, surfaceHeight);
    return std::fabs(ahead - height) < kSameHeight
               ? ahead
               : std::max(ahead, m_surface->underfoot(body.x, body.z, surfaceHeight));
}

/// Keeps somebody who walks on the surface that he walks on, at the height of what is underfoot;
/// who has come to rest until he is there.
void Session::stand(std::uint32_t agent)
{
    const Shown& shown = m_shown[agent];
    Standing& standing = m_standing[agent];
    Body& body = m_crowd.bodies()[agent];
    if (shown.isGone || shown.isPut || shown.sitting == Sitting::Settles ||
        shown.sitting == Sitting::Sits) {
        standing = {};
        return;
    }
    const bool isWalking = body.preferredSpeed != 0.0F;
    if (!isWalking && standing.isSettled) {
        return;
    }
    standing.isSettled = !isWalking;
    float& height = m_crowd.heights()[agent];
    if (!m_surface->follow(standing.footing, {body.x, height, body.z})) {
        return;
    }
    const glm::vec3& point = standing.footing.point;
    const glm::vec2 off(body.x - point.x, body.z - point.z);
    const float away = std::sqrt(off.x * off.x + off.y * off.y);
    if (away > m_surface->margin()) {
        // The crowd has pushed him over an edge.
        body.x = point.x + off.x * (m_surface->margin() / away);
        body.z = point.z + off.y * (m_surface->margin() / away);
    }
    const float ground = groundAhead(body, height, point.y);
    const float left = ground - height;
    standing.isSettled = !isWalking && std::fabs(left) < kSameHeight;
    height = standing.isSettled ? ground : height + left * m_rampShare;
}

void Session::follow(std::size_t begin, std::size_t end)
{
    for (std::size_t agent = begin; agent < end && m_surface; ++agent) {
        stand(static_cast<std::uint32_t>(agent));
    }
    const std::span<const Body> bodies = m_crowd.bodies();
    const std::span<float> heights = m_crowd.heights();
    const StrideParameters parameters{
        m_stepSeconds, m_smoothing, kTurnRadiansPerSecond * m_stepSeconds,
        kTurnsAbove,   kMovesAbove, kFastestStride};
    std::array<std::uint32_t, kStrideBlock + kLanes> list;
    const std::size_t looks =
        strideOn(bodies, heights, m_motion, parameters, begin, end, list.data());
    for (std::size_t i = 0; i < looks; ++i) {
        look(list[i]);
    }
}

/// Those who are where they are, whatever the crowd says. False: nothing else happens to him.
bool Session::placeBody(std::uint32_t agent)
{
    Shown& shown = m_shown[agent];
    Body& body = m_crowd.bodies()[agent];
    float& height = m_crowd.heights()[agent];
    if (shown.isGone) {
        // Out of everybody's way, spread as they were at the beginning.
        const glm::vec3 start = m_population.column(model::columns::position)[agent];
        const bool isSomewhere = model::Bounds::isPlace(start);
        body.x = isSomewhere ? start.x : 0.0F;
        body.z = isSomewhere ? start.z : 0.0F;
        height = kGoneHeight;
        return false;
    }
    if (shown.isPut || shown.sitting == Sitting::Settles || shown.sitting == Sitting::Sits) {
        body.x = m_motion.x[agent];
        body.z = m_motion.z[agent];
        height = m_motion.y[agent];
        body.velocityX = 0.0F;
        body.velocityZ = 0.0F;
        shown.isPut = false;
    }
    return true;
}

/// Body, heading, gait and clip of somebody.
void Session::look(std::uint32_t agent)
{
    Shown& shown = m_shown[agent];
    if (!placeBody(agent)) {
        return;
    }
    const Body& body = m_crowd.bodies()[agent];
    const float speed =
        std::sqrt(body.velocityX * body.velocityX + body.velocityZ * body.velocityZ);
    if (speed > kMovesAbove || shown.order >= 0 || shown.isTurning || body.preferredSpeed > 0.0F) {
        activate(agent);
    }
    if (!isLive(agent)) {
        m_motion.mode[agent] = static_cast<std::int32_t>(UpdateMode::Rest);
        return;
    }
    const glm::vec2 way(body.x - m_motion.x[agent], body.z - m_motion.z[agent]);
    m_motion.put(agent, {body.x, m_crowd.heights()[agent], body.z});
    if (shown.sitting != Sitting::Settles) {
        m_motion.speed[agent] += (speed - m_motion.speed[agent]) * m_smoothing;
    }
    turn(agent, speed);
    const float heading = m_motion.heading[agent];
    const float ahead = (way.x * std::sin(heading) + way.y * std::cos(heading)) / m_stepSeconds;
    m_motion.stride[agent] = ahead < kFastestStride ? std::max(ahead, 0.0F) : 0.0F;
    goOnWithOrder(shown);
    followGait(agent, speed, body.preferredSpeed > 0.0F);
    noteClip(agent);
    setUpdateMode(agent);
}

void Session::turn(std::uint32_t agent, float speed)
{
    Shown& shown = m_shown[agent];
    float& heading = m_motion.heading[agent];
    if (speed > kTurnsAbove) {
        const Body& body = m_crowd.bodies()[agent];
        heading = turnedTo(heading, std::atan2(body.velocityX, body.velocityZ));
        shown.isTurning = false;
    } else if (shown.isTurning) {
        heading = turnedTo(heading, shown.facing);
    }
}

/// The clip that a rule lets somebody play.
void Session::goOnWithOrder(Shown& shown) const
{
    const ClipFacts* facts = clipFacts(shown, shown.order);
    if (facts == nullptr) {
        return;
    }
    shown.orderPlace += facts->seconds > 0.0F ? static_cast<double>(m_stepSeconds) /
                                                    static_cast<double>(facts->seconds)
                                              : 0.0;
    shown.orderPlace = shown.isOrderLooped ? shown.orderPlace - std::floor(shown.orderPlace)
                                           : std::min(shown.orderPlace, 1.0);
    if (shown.isOrderOwn && shown.orderPlace >= 1.0) {
        shown.order = -1;
    }
}

/// Feet set off and come to rest with the body; in between nobody changes his gait for a moment.
void Session::followGait(std::uint32_t agent, float speed, bool wantsOn)
{
    Shown& shown = m_shown[agent];
    const float smooth = m_motion.speed[agent];
    const float metresPerSecond = !wantsOn          ? speed
                                  : shown.gait == 0 ? std::max(speed, smooth)
                                                    : smooth;
    if (shown.table >= m_gaits.size() || m_gaits[shown.table].isEmpty()) {
        return;
    }
    const GaitTable& table = m_gaits[shown.table];
    const GaitTable::Gait& former = table.gait(shown.gait);
    const bool stood = shown.gait == 0;
    // Who comes to rest finishes with the walk that he has.
    const bool keepsGait = !wantsOn && !stood && former.metresPerSecond < kRunsAbove;
    const auto chosen = static_cast<std::uint32_t>(
        table.choose(shown.gait, metresPerSecond, keepsGait ? shown.gait : shown.style));
    const GaitTable::Gait& gait = table.gait(chosen);
    auto place = static_cast<double>(m_motion.gaitPlace[agent]);
    if (stood && chosen != 0) {
        place = GaitTable::nearestTogether(gait, place);
        m_motion.speed[agent] = std::max(smooth, metresPerSecond);
    }
    if (stood || chosen == 0) {
        shown.gait = chosen;
    } else if (chosen != shown.gait && GaitTable::isAboutToPass(former, place)) {
        place = GaitTable::placeInto(former, gait, place);
        shown.gait = chosen;
    }
    const GaitTable::Gait& present = table.gait(shown.gait);
    if (present.seconds > 0.0F) {
        const float rate = GaitTable::playback(present, m_motion.stride[agent], shown.height);
        place += static_cast<double>(rate * m_stepSeconds) / static_cast<double>(present.seconds);
        place -= std::floor(place);
    }
    m_motion.gaitPlace[agent] = static_cast<float>(place);
}

/// What he shows, and whether it is another clip than a step ago, so that one goes over into the
/// other.
void Session::noteClip(std::uint32_t agent)
{
    Shown& shown = m_shown[agent];
    MotionState& b = m_motion;
    const Showing showing = showingOf(agent);
    if (shown.hasLast && b.clip[agent] != showing.clip.clip) {
        ClipPlace last{b.clip[agent], (b.flags[agent] & kPoseLooped) != 0, b.rate[agent],
                       b.clipSeconds[agent], static_cast<double>(b.place[agent])};
        if ((b.flags[agent] & kPoseClock) != 0) {
            last.place = last.placeAt(seconds() - static_cast<double>(m_stepSeconds));
        }
        shown.from = last;
        shown.fromGait = shown.lastGait;
        shown.fadeBegin = seconds();
    }
    goOnFading(agent);
    b.clip[agent] = showing.clip.clip;
    b.rate[agent] = showing.clip.rate;
    b.clipSeconds[agent] = showing.clip.clipSeconds;
    b.place[agent] = static_cast<float>(showing.clip.place);
    b.isGaitShown[agent] = showing.isGait ? -1 : 0;
    b.flags[agent] = flagsOf(shown, showing, b.flags[agent]);
    const bool isOfGait =
        shown.gait != 0 && shown.table < m_gaits.size() && !m_gaits[shown.table].isEmpty();
    shown.lastGait = isOfGait ? shown.gait : 0;
    shown.hasLast = true;
}

/// Of what is shown, PoseFlag.
std::uint8_t Session::flagsOf(const Shown& shown, const Showing& showing, std::uint8_t before) const
{
    const bool isFading = shown.fadeBegin >= 0.0 && seconds() - shown.fadeBegin < kFadeSeconds;
    return static_cast<std::uint8_t>(
        (before & kPoseLive) | (showing.clip.isLooped ? kPoseLooped : 0) |
        (shown.isGone ? kPoseGone : 0) | (showing.isClock ? kPoseClock : 0) |
        (isFading ? kPoseFading : 0));
}

/// What is being left goes on too, at the pace of the body where that moved it.
void Session::goOnFading(std::uint32_t agent)
{
    Shown& shown = m_shown[agent];
    if (shown.fadeBegin < 0.0 || seconds() - shown.fadeBegin >= kFadeSeconds) {
        return;
    }
    if (shown.fromGait != 0 && shown.table < m_gaits.size() && !m_gaits[shown.table].isEmpty()) {
        const GaitTable::Gait& gait = m_gaits[shown.table].gait(shown.fromGait);
        shown.from.rate = GaitTable::playback(gait, m_motion.stride[agent], shown.height);
    }
    if (shown.from.clipSeconds > 0.0F) {
        shown.from.place += static_cast<double>(m_stepSeconds * shown.from.rate) /
                            static_cast<double>(shown.from.clipSeconds);
    }
}

/// What the next steps may do with somebody, now that he has been looked at.
void Session::setUpdateMode(std::uint32_t agent)
{
    const Shown& shown = m_shown[agent];
    MotionState& b = m_motion;
    const bool isFading = (b.flags[agent] & kPoseFading) != 0;
    if (shown.order >= 0 || shown.isTurning || isFading || shown.sitting == Sitting::Settles ||
        shown.sitting == Sitting::Sits) {
        b.mode[agent] = static_cast<std::int32_t>(UpdateMode::Full);
        return;
    }
    b.mode[agent] = static_cast<std::int32_t>(UpdateMode::Continue);
    if (shown.table >= m_gaits.size() || m_gaits[shown.table].isEmpty()) {
        b.perMetre[agent] = 0.0F;
        b.perSecond[agent] = 0.0F;
        b.slowest[agent] = -1.0F;
        b.fastest[agent] = std::numeric_limits<float>::infinity();
        return;
    }
    const GaitTable& table = m_gaits[shown.table];
    const GaitTable::Gait& gait = table.gait(shown.gait);
    const GaitTable::Limits limits = table.limits(shown.gait, shown.style);
    b.perMetre[agent] = gait.metresPerSecond > 0.0F && !gait.isFree
                            ? GaitTable::playback(gait, 1.0F, shown.height)
                            : 0.0F;
    b.perSecond[agent] = gait.seconds > 0.0F && !gait.isFrozen ? 1.0F / gait.seconds : 0.0F;
    b.slowest[agent] = limits.slowest;
    b.fastest[agent] = limits.fastest;
}

Session::Showing Session::showingOf(std::uint32_t agent) const
{
    const Shown& shown = m_shown[agent];
    const bool hasGaits = shown.table < m_gaits.size() && !m_gaits[shown.table].isEmpty();
    const std::uint32_t gait = hasGaits ? shown.gait : 0;
    if (const ClipFacts* facts = clipFacts(shown, shown.order); facts != nullptr && gait == 0) {
        return {{static_cast<std::uint16_t>(shown.order), facts->isLooped, 1.0F, facts->seconds,
                 shown.orderPlace}};
    }
    const std::uint16_t own = ownClip(agent);
    const ClipFacts* ownFacts = clipFacts(shown, own);
    const bool isMover = ownFacts != nullptr && ownFacts->isMover;
    if (!hasGaits || (gait == 0 && !isMover)) {
        // Standing he does what the scene lets him do.
        return {{own, ownFacts == nullptr || ownFacts->isLooped, ownRate(agent),
                 ownFacts == nullptr ? 0.0F : ownFacts->seconds, ownPhase(agent)},
                false,
                true};
    }
    const GaitTable::Gait& chosen = m_gaits[shown.table].gait(gait);
    return {{chosen.clip, true, GaitTable::playback(chosen, m_motion.stride[agent], shown.height),
             chosen.seconds, static_cast<double>(m_motion.gaitPlace[agent])},
            true};
}

} // namespace crowd::behavior
