// SPDX-License-Identifier: MIT
#include "behavior/session/Companions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "behavior/rules/PlaceRooms.h"
#include "behavior/session/SessionParts.h"
#include "model/base/Random.h"

namespace crowd::behavior {

namespace {

constexpr double kLooksEachSeconds = 0.3; ///< after a leader, and round for others
constexpr float kSetsOut = 0.6F;          ///< metres beyond the distance that is kept
constexpr float kFollowersBeside = 0.45F; ///< metres: not all to the same point
constexpr float kFarBehindLeader = 4.0F;  ///< metres at which one hurries most
constexpr float kFollowersHaste = 0.4F;   ///< share of the leader's speed on top of it
constexpr float kStandsBelow = 0.1F;      ///< m/s
constexpr float kBerth = 1.5F;            ///< times the own speed, aside
constexpr float kBack = 0.3F;             ///< of that, straight away
constexpr float kFollowerTurn = 6.2831853F;
constexpr std::uint64_t kFollowersPlace = 95; ///< purpose of draws

/// Free to do something of his own.
bool isIdle(const SessionParts& parts, std::uint32_t agent)
{
    return parts.agents.isGone[agent] == 0 && !parts.rules.isBusy(agent) &&
           !parts.seating.isSeated(agent) && !parts.agents.isOnWayToSeat(agent) &&
           parts.follower.pathOf(agent) == 0;
}

} // namespace

void Companions::read(const model::Scene& scene)
{
    std::vector<std::uint32_t> followers;
    for (const Kept& kept : m_kept) {
        if (kept.isFollowing) {
            followers.push_back(kept.agent);
        }
    }
    m_kept.clear();
    m_ties.clear();
    if (scene.relations.isEmpty()) {
        return;
    }
    const model::Population& people = scene.population;
    for (std::size_t row = 0; row < people.size(); ++row) {
        Kept kept{static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(m_ties.size())};
        for (const model::RelationLink& link : scene.relations.of(people.ids()[row])) {
            const model::RelationKind* kind = findRelation(scene.relationKinds, link.kind);
            const std::size_t other = people.rowOf(link.other);
            if (kind == nullptr || !kind->isActive() || other == model::Population::npos) {
                continue;
            }
            const bool isLed = kind->walk == model::RelationWalk::Behind && !link.isOut;
            const model::RelationWalk walk = kind->walk == model::RelationWalk::Behind && !isLed
                                                 ? model::RelationWalk::Own
                                                 : kind->walk;
            m_ties.push_back({static_cast<std::uint32_t>(other), kind->walkMetres, walk,
                              kind->facesEachOther ? kind->faceMetres : 0.0F});
        }
        kept.ties = static_cast<std::uint32_t>(m_ties.size()) - kept.firstTie;
        kept.isFollowing = std::ranges::binary_search(followers, kept.agent);
        if (kept.ties > 0) {
            m_kept.push_back(kept);
        }
    }
}

/// The nearest of those who lead him; kNoAgent: nobody who is here does.
std::uint32_t Companions::leaderOf(const Kept& kept, const RuleHost& host, float& metres) const
{
    std::uint32_t leader = kNoAgent;
    float best = std::numeric_limits<float>::max();
    for (std::uint32_t i = kept.firstTie; i < kept.firstTie + kept.ties; ++i) {
        const Tie& tie = m_ties[i];
        const float away = flatDistance(host.position(kept.agent), host.position(tie.other));
        if (tie.walk == model::RelationWalk::Behind && !host.isGone(tie.other) && away < best) {
            leader = tie.other;
            best = away;
            metres = tie.metres;
        }
    }
    return leader;
}

void Companions::follow(Kept& kept, SessionParts& parts, RuleHost& host) const
{
    float metres = 0.0F;
    const std::uint32_t leader = leaderOf(kept, host, metres);
    if (leader == kNoAgent || !isIdle(parts, kept.agent)) {
        kept.isFollowing = false;
        return;
    }
    const glm::vec3 to = host.position(leader);
    const float away = flatDistance(host.position(kept.agent), to);
    if (away > metres + (kept.isFollowing ? 0.0F : kSetsOut)) {
        const float angle =
            kFollowerTurn * model::unitFloat(model::hashKeys(host.id(kept.agent), host.id(leader),
                                                             kFollowersPlace));
        const glm::vec3 beside(std::sin(angle), 0.0F, std::cos(angle));
        const float behind = std::clamp((away - metres) / kFarBehindLeader, 0.0F, 1.0F);
        parts.rules.forgetGoal(kept.agent);
        host.sendTo(kept.agent, to + beside * kFollowersBeside,
                    host.speed(leader) * (1.0F + kFollowersHaste * behind));
        kept.isFollowing = true;
    } else if (kept.isFollowing) {
        host.stop(kept.agent);
        kept.isFollowing = false;
    }
}

/// Who wants to go on turns away from whom he is to keep apart from, the more the nearer.
void Companions::keepApart(const Kept& kept, SessionParts& parts) const
{
    Body& body = parts.crowd.bodies()[kept.agent];
    if (body.preferredSpeed <= 0.0F) {
        return;
    }
    const glm::vec2 wanted(body.desiredX, body.desiredZ);
    const float speed = std::sqrt(wanted.x * wanted.x + wanted.y * wanted.y);
    if (speed <= 0.0F) {
        return;
    }
    const glm::vec2 side(-wanted.y / speed, wanted.x / speed);
    glm::vec2 turned(0.0F);
    for (std::uint32_t i = kept.firstTie; i < kept.firstTie + kept.ties; ++i) {
        const Tie& tie = m_ties[i];
        const Body& other = parts.crowd.bodies()[tie.other];
        const glm::vec2 away(body.x - other.x, body.z - other.z);
        const float distance = std::sqrt(away.x * away.x + away.y * away.y);
        if (tie.walk == model::RelationWalk::Apart && parts.agents.isGone[tie.other] == 0 &&
            distance < tie.metres && distance > 0.0F) {
            const float share = 1.0F - distance / tie.metres;
            const float beside = away.x * side.x + away.y * side.y;
            turned += side * (beside < 0.0F ? -share : share) + away * (share / distance) * kBack;
        }
    }
    const glm::vec2 now = wanted + turned * (kBerth * speed);
    const float length = std::sqrt(now.x * now.x + now.y * now.y);
    if (length > 0.0F && (turned.x != 0.0F || turned.y != 0.0F)) {
        body.desiredX = now.x * std::min(1.0F, speed / length);
        body.desiredZ = now.y * std::min(1.0F, speed / length);
    }
}

/// To the middle of those who stand near him.
void Companions::face(const Kept& kept, const SessionParts& parts, RuleHost& host) const
{
    const auto stands = [&](std::uint32_t agent) {
        return !host.isGone(agent) && host.speed(agent) < kStandsBelow &&
               parts.crowd.bodies()[agent].preferredSpeed <= 0.0F;
    };
    if (!isIdle(parts, kept.agent) || !stands(kept.agent)) {
        return;
    }
    const glm::vec3 at = host.position(kept.agent);
    glm::vec3 middle(0.0F);
    float count = 0.0F;
    for (std::uint32_t i = kept.firstTie; i < kept.firstTie + kept.ties; ++i) {
        const Tie& tie = m_ties[i];
        if (tie.faceMetres > 0.0F && flatDistance(host.position(tie.other), at) <= tie.faceMetres &&
            stands(tie.other)) {
            middle += host.position(tie.other);
            count += 1.0F;
        }
    }
    if (count > 0.0F) {
        host.turnTo(kept.agent, middle / count);
    }
}

void Companions::step(SessionParts& parts, RuleHost& host)
{
    if (m_kept.empty()) {
        return;
    }
    const auto period = static_cast<std::uint64_t>(
        std::max(1.0, std::floor(kLooksEachSeconds * parts.clock.stepsPerSecond)));
    for (Kept& kept : m_kept) {
        keepApart(kept, parts);
        if ((parts.clock.steps + kept.agent) % period == 0) { // not all in the same step
            follow(kept, parts, host);
            face(kept, parts, host);
        }
    }
}

} // namespace crowd::behavior
