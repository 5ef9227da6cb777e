// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

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
            const Shown& shown = m_shown[agent];
            if (speed < kMovesAbove || shown.isGone || shown.isPut ||
                shown.sitting != Sitting::No || shown.table >= m_gaits.size() ||
                m_gaits[shown.table].isEmpty()) {
                continue;
            }
            const GaitTable::Gait& gait = m_gaits[shown.table].gait(shown.gait);
            body.preferredSpeed = -GaitTable::braking(gait, shown.place, speed, shown.height);
        }
    });
}

/// Body, heading and gait of somebody.
void Session::show(std::uint32_t agent)
{
    Body& body = m_crowd.bodies()[agent];
    float& height = m_crowd.heights()[agent];
    Shown& shown = m_shown[agent];
    if (shown.isGone) {
        // Out of everybody's way, spread as they were at the beginning.
        const glm::vec3 start = m_population.column(model::columns::position)[agent];
        const bool isSomewhere = model::Bounds::isPlace(start);
        body.x = isSomewhere ? start.x : 0.0F;
        body.z = isSomewhere ? start.z : 0.0F;
        height = kGoneHeight;
        return;
    }
    if (shown.isPut || shown.sitting == Sitting::Settles || shown.sitting == Sitting::Sits) {
        body.x = shown.position.x;
        body.z = shown.position.z;
        height = shown.position.y;
        body.velocityX = 0.0F;
        body.velocityZ = 0.0F;
        shown.isPut = false;
    }
    const float velocityX = body.velocityX;
    const float velocityZ = body.velocityZ;
    const float speed = std::sqrt(velocityX * velocityX + velocityZ * velocityZ);
    shown.isLive = shown.isLive || speed > kMovesAbove || shown.order >= 0 || shown.isTurning ||
                   body.preferredSpeed > 0.0F;
    if (!shown.isLive) {
        return;
    }
    if (m_surface && body.preferredSpeed != 0.0F) {
        const float ground = m_surface->height(body.x, body.z, height);
        height += (ground - height) * m_rampShare;
    }
    const glm::vec2 way(body.x - shown.position.x, body.z - shown.position.z);
    shown.position = {body.x, height, body.z};
    if (shown.sitting != Sitting::Settles) {
        shown.speed += (speed - shown.speed) * m_smoothing;
    }
    if (speed > kTurnsAbove) {
        shown.heading = turnedTo(shown.heading, std::atan2(velocityX, velocityZ));
        shown.isTurning = false;
    } else if (shown.isTurning) {
        shown.heading = turnedTo(shown.heading, shown.facing);
    }
    const float ahead = way.x * std::sin(shown.heading) + way.y * std::cos(shown.heading);
    shown.stride =
        ahead < kFastestStride * m_stepSeconds ? std::max(ahead / m_stepSeconds, 0.0F) : 0.0F;
    if (const ClipFacts* facts = clipFacts(shown, shown.order)) {
        shown.orderPlace += facts->seconds > 0.0F ? static_cast<double>(m_stepSeconds) /
                                                        static_cast<double>(facts->seconds)
                                                  : 0.0;
        shown.orderPlace = shown.isOrderLooped ? shown.orderPlace - std::floor(shown.orderPlace)
                                               : std::min(shown.orderPlace, 1.0);
        if (shown.isOrderOwn && shown.orderPlace >= 1.0) {
            shown.order = -1;
        }
    }
    followGait(shown, speed, body.preferredSpeed > 0.0F);
    noteClip(agent);
}

/// Feet set off and come to rest with the body; in between nobody changes his gait for a moment.
void Session::followGait(Shown& shown, float speed, bool wantsOn) const
{
    const float metresPerSecond = !wantsOn          ? speed
                                  : shown.gait == 0 ? std::max(speed, shown.speed)
                                                    : shown.speed;
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
    if (stood && chosen != 0) {
        shown.place = GaitTable::nearestTogether(gait, shown.place);
        shown.speed = std::max(shown.speed, metresPerSecond);
    }
    if (stood || chosen == 0) {
        shown.gait = chosen;
    } else if (chosen != shown.gait && GaitTable::isAboutToPass(former, shown.place)) {
        shown.place = GaitTable::placeInto(former, gait, shown.place);
        shown.gait = chosen;
    }
    const GaitTable::Gait& present = table.gait(shown.gait);
    if (present.seconds > 0.0F) {
        const float rate = GaitTable::playback(present, shown.stride, shown.height);
        shown.place +=
            static_cast<double>(rate * m_stepSeconds) / static_cast<double>(present.seconds);
        shown.place -= std::floor(shown.place);
    }
}

/// Whether it is another clip than a step ago, so that one goes over into the other.
void Session::noteClip(std::uint32_t agent)
{
    Shown& shown = m_shown[agent];
    const PersonPose pose = poseOf(agent);
    const bool isOfGait =
        shown.gait != 0 && shown.table < m_gaits.size() && !m_gaits[shown.table].isEmpty();
    if (shown.hasLast && shown.last.clip != pose.clip) {
        shown.from = shown.last;
        shown.fromGait = shown.lastGait;
        shown.fadeBegin = seconds();
    }
    goOnFading(shown);
    shown.last = {pose.clip, pose.isLooped, pose.rate, pose.clipSeconds, pose.place};
    shown.lastGait = isOfGait ? shown.gait : 0;
    shown.hasLast = true;
}

/// What is being left goes on too, at the pace of the body where that moved it.
void Session::goOnFading(Shown& shown) const
{
    if (shown.fadeBegin < 0.0 || seconds() - shown.fadeBegin >= kFadeSeconds) {
        return;
    }
    if (shown.fromGait != 0 && shown.table < m_gaits.size() && !m_gaits[shown.table].isEmpty()) {
        const GaitTable::Gait& gait = m_gaits[shown.table].gait(shown.fromGait);
        shown.from.rate = GaitTable::playback(gait, shown.stride, shown.height);
    }
    if (shown.from.clipSeconds > 0.0F) {
        shown.from.place += static_cast<double>(m_stepSeconds * shown.from.rate) /
                            static_cast<double>(shown.from.clipSeconds);
    }
}

PersonPose Session::poseOf(std::size_t agent) const
{
    const Shown& shown = m_shown[agent];
    PersonPose pose;
    pose.id = m_population.ids()[agent];
    pose.isGone = shown.isGone;
    pose.from = shown.from;
    pose.fadeBegin = shown.fadeBegin;
    pose.seat = shown.sitting == Sitting::Goes || shown.sitting == Sitting::Settles ? model::kNoSeat
                                                                                    : shown.seat;
    pose.position = shown.position;
    pose.heading = shown.heading;
    const bool hasGaits = shown.table < m_gaits.size() && !m_gaits[shown.table].isEmpty();
    const std::uint32_t gait = hasGaits ? shown.gait : 0;
    if (const ClipFacts* facts = clipFacts(shown, shown.order); facts != nullptr && gait == 0) {
        pose.clip = static_cast<std::uint16_t>(shown.order);
        pose.isLooped = facts->isLooped;
        pose.clipSeconds = facts->seconds;
        pose.place = shown.orderPlace;
        return pose;
    }
    const auto who = static_cast<std::uint32_t>(agent);
    const std::uint16_t own = ownClip(who);
    const ClipFacts* ownFacts = clipFacts(shown, own);
    const bool isMover = ownFacts != nullptr && ownFacts->isMover;
    if (!hasGaits || (gait == 0 && !isMover)) {
        // Standing he does what the scene lets him do.
        pose.clip = own;
        pose.isLooped = ownFacts == nullptr || ownFacts->isLooped;
        pose.clipSeconds = ownFacts == nullptr ? 0.0F : ownFacts->seconds;
        pose.rate = ownRate(who);
        pose.place = ownPlace(who);
        return pose;
    }
    const GaitTable::Gait& chosen = m_gaits[shown.table].gait(gait);
    pose.clip = chosen.clip;
    pose.rate = GaitTable::playback(chosen, shown.stride, shown.height);
    pose.clipSeconds = chosen.seconds;
    pose.place = shown.place;
    return pose;
}

SessionPosePtr Session::pose() const
{
    auto pose = std::make_shared<SessionPose>();
    pose->step = m_steps;
    pose->seconds = seconds();
    pose->hasSeats = m_hasSat;
    pose->looks = m_shownLooks;
    pose->numbers = m_ownNumbers;
    pose->people.reserve(m_shown.size());
    for (std::size_t agent = 0; agent < m_shown.size(); ++agent) {
        if (m_shown[agent].isLive) {
            pose->people.push_back(poseOf(agent));
        }
        if (m_rules.isLit(static_cast<std::uint32_t>(agent))) {
            pose->lit.push_back(m_population.ids()[agent]);
        }
    }
    return pose;
}

model::CrowdFramePtr Session::frame() const
{
    model::CrowdFrame frame{m_population, m_templates, seconds()};
    const SessionPosePtr now = pose();
    applyPose(*now, *now, frame);
    return std::make_shared<const model::CrowdFrame>(std::move(frame));
}

} // namespace crowd::behavior
