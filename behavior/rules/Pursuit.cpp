// SPDX-License-Identifier: MIT
#include "behavior/rules/Pursuit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "behavior/rules/Aims.h"
#include "behavior/rules/Errands.h"
#include "behavior/rules/RelatedAgents.h"
#include "model/base/Random.h"

namespace crowd::behavior {

namespace {

constexpr float kAllRound = 6.2831853F;
constexpr float kLeastDistance = 0.6F;   ///< metres between two who stand together
constexpr float kAimsAnew = 0.3F;        ///< metres that the other one has gone on
constexpr float kSetsOutAgain = 0.5F;    ///< metres beyond the distance that is kept
constexpr float kBeside = 0.35F;         ///< metres: not all to the same point
constexpr float kFarBehind = 4.0F;       ///< metres at which one hurries most
constexpr float kHaste = 0.4F;           ///< share of the other one's speed on top of it
constexpr double kPatienceSeconds = 5.0; ///< without getting on
constexpr float kGetsOnAbove = 0.15F;    ///< m/s
constexpr float kGivesWayWithin = 3.0F;  ///< metres before whom he follows
constexpr float kLaneMetres = 0.9F;      ///< to either side of where that one wants to go

constexpr glm::vec3 kAimedNowhere{std::numeric_limits<float>::max()};

/// m/s of who follows somebody of that speed from `behind` (metres) further away than he is to.
float catchingUp(float speed, float behind)
{
    return speed * (1.0F + kHaste * std::clamp(behind / kFarBehind, 0.0F, 1.0F));
}

/// Whom somebody goes to: the one that he began with, as long as it can be he.
std::optional<Aim> partnerOf(const ActionScope& scope, const model::AimChoice& choice)
{
    const AgentStates& agents = scope.state.agents;
    model::IndividualId& partner = scope.progress().pursuit.partner;
    const std::uint32_t former = partner != 0 ? agents.agentNamed(partner) : kNoAgent;
    const auto isMeant = [&](std::uint32_t other) {
        return choice.aim == model::ActionAim::Related
                   ? areRelated(scope.state, scope.agent, other, choice.relation)
                   : choice.aim == model::ActionAim::Sender || agents.hasTag(other, choice.tag);
    };
    const bool isStill = former != kNoAgent && !scope.host.isGone(former) && isMeant(former);
    if (isStill) {
        return Aim{scope.host.position(former), former};
    }
    const std::optional<Aim> aim = aimOf(scope, choice);
    partner = aim && aim->agent != kNoAgent ? scope.host.id(aim->agent) : 0;
    return aim;
}

void start(const ActionScope& scope, const PursuitSettings& settings)
{
    ActionProgress& progress = scope.progress();
    progress.isStarted = true;
    progress.until = endAfter(scope, settings.seconds);
    progress.nextUpdate = scope.now();
    progress.pursuit = {0, kAimedNowhere, true, scope.now()}; // stands, until he sets out
    scope.self().errand.goal = 0;
    holdPlace(scope.state, scope.agent, 0);
}

ActionStatus stop(const ActionScope& scope)
{
    scope.host.stop(scope.agent);
    return ActionStatus::Done;
}

/// Out of the way of whom he follows, to the side on which he stands. False: he is not in it.
bool giveWay(const ActionScope& scope, std::uint32_t other)
{
    const RuleHost& host = scope.host;
    const glm::vec2 wanted = host.wantedVelocity(other);
    const float speed = std::sqrt(wanted.x * wanted.x + wanted.y * wanted.y);
    if (speed < kGetsOnAbove) {
        return false;
    }
    const glm::vec2 ahead = wanted / speed;
    const glm::vec3 way = host.position(scope.agent) - host.position(other);
    const float before = way.x * ahead.x + way.z * ahead.y;
    const float beside = way.x * ahead.y - way.z * ahead.x;
    if (before < 0.0F || before > kGivesWayWithin || std::fabs(beside) > kLaneMetres) {
        return false;
    }
    const float side = (beside < 0.0F ? -1.0F : 1.0F) * (kLaneMetres + kBeside);
    const glm::vec3 aside(ahead.y * side, 0.0F, -ahead.x * side);
    const glm::vec3 level(ahead.x * before, 0.0F, ahead.y * before);
    PursuitState& pursuit = scope.progress().pursuit;
    pursuit.isNear = false;
    pursuit.aimedAt = kAimedNowhere;
    pursuit.movedAt = scope.now();
    sendTo(scope, host.position(other) + level + aside, 0.0F);
    return true;
}

/// Stands as near as he is to and turns to the other one. True: and moves no more.
bool standNear(const ActionScope& scope, const Aim& aim, bool isFirst)
{
    PursuitState& pursuit = scope.progress().pursuit;
    if (!pursuit.isNear || isFirst) {
        scope.host.stop(scope.agent);
    }
    pursuit.isNear = true;
    pursuit.aimedAt = aim.point;
    scope.host.turnTo(scope.agent, aim.point); // once he stands: who moves looks ahead
    return scope.host.speed(scope.agent) < kGetsOnAbove;
}

/// To beside where the other one is now.
void goBeside(const ActionScope& scope, const Aim& aim, float atLeast)
{
    PursuitState& pursuit = scope.progress().pursuit;
    const float angle =
        kAllRound *
        model::unitFloat(model::hashKeys(scope.state.seed, scope.host.id(scope.agent), 84));
    sendTo(scope, aim.point + kBeside * glm::vec3(std::sin(angle), 0.0F, std::cos(angle)), atLeast);
    pursuit.aimedAt = aim.point;
    pursuit.isNear = false;
}

/// Nearer to where the aim is now. Done as pursue().
ActionStatus comeNear(const ActionScope& scope, const PursuitSettings& settings, const Aim& aim)
{
    PursuitState& pursuit = scope.progress().pursuit;
    const bool isFollowing = settings.isFollowing;
    const float away = flatDistance(scope.host.position(scope.agent), aim.point);
    const float distance = std::max(settings.metres, kLeastDistance);
    if (isFollowing && giveWay(scope, aim.agent)) {
        return ActionStatus::Running;
    }
    const bool isFirst = pursuit.aimedAt.x == kAimedNowhere.x;
    if (away <= distance + (pursuit.isNear && !isFirst ? kSetsOutAgain : 0.0F)) {
        const bool isThere = standNear(scope, aim, isFirst);
        return isThere && !isFollowing ? ActionStatus::Done : ActionStatus::Running;
    }
    if (scope.host.speed(scope.agent) > kGetsOnAbove) {
        pursuit.movedAt = scope.now();
    } else if (!isFollowing && scope.now() > pursuit.movedAt + kPatienceSeconds) {
        return stop(scope); // nobody gets through
    }
    if (pursuit.isNear || flatDistance(pursuit.aimedAt, aim.point) > kAimsAnew) {
        goBeside(scope, aim,
                 isFollowing ? catchingUp(scope.host.speed(aim.agent), away - distance) : 0.0F);
    }
    return ActionStatus::Running;
}

/// Asks where the aim is now.
ActionStatus update(const ActionScope& scope, const PursuitSettings& settings)
{
    scope.progress().nextUpdate = scope.now() + kAimUpdateSeconds;
    const std::optional<Aim> aim = partnerOf(scope, settings.aim);
    if (aim && (!settings.isFollowing || aim->agent != kNoAgent)) {
        return comeNear(scope, settings, *aim);
    }
    if (settings.isFollowing && settings.aim.aim == model::ActionAim::Sender) {
        scope.report(QT_TRANSLATE_NOOP(
            "Messages", "Rule \"%1\" follows whoever sent the event, but it came from a brush, a "
                        "cue or nobody. Let characters send it, or follow those with a tag."));
    }
    return stop(scope);
}

} // namespace

ActionStatus pursue(const ActionScope& scope, const PursuitSettings& settings)
{
    const ActionProgress& progress = scope.progress();
    if (scope.host.isGone(scope.agent)) {
        return ActionStatus::Done;
    }
    if (!progress.isStarted) {
        start(scope, settings);
    } else if (scope.now() >= progress.until) {
        return stop(scope);
    }
    if (!settings.isFollowing && !progress.pursuit.isNear && hasErrandEnded(scope, scope.agent)) {
        return ActionStatus::Done; // as near as he gets
    }
    return scope.now() >= progress.nextUpdate ? update(scope, settings) : ActionStatus::Running;
}

} // namespace crowd::behavior
