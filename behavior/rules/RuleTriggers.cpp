// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "behavior/motion/TravelEvents.h"
#include "behavior/rules/RuleEngine.h"
#include "model/base/Overloaded.h"
#include "model/base/Random.h"

/// What rules wait for and ask.
namespace crowd::behavior {

namespace {

constexpr float kStandsBelow = 0.1F; ///< m/s
constexpr float kSpeedMargin = 0.1F; ///< share of a limit by which it must be crossed

bool compares(float asked, model::Comparison comparison, float value)
{
    switch (comparison) {
    case model::Comparison::Less:
        return asked < value;
    case model::Comparison::Equal:
        return std::fabs(asked - value) <= 1e-4F * std::max(1.0F, std::fabs(value));
    case model::Comparison::More:
        return asked > value;
    }
    return false;
}

} // namespace

bool RuleEngine::isTime(RuleHost& host, std::uint32_t index, std::uint32_t agent,
                        const model::triggers::Every& trigger)
{
    const std::uint32_t count = m_memory[index].of[agent].count;
    double& due = m_memory[index].due[agent];
    const double period = std::max(1.0 / 30.0, static_cast<double>(trigger.seconds));
    const std::uint64_t key = model::hashKeys(m_seed, host.id(agent), m_rules[index].id, count, 51);
    if (due < 0.0) {
        due = m_now + period * model::unitDouble(key); // not all at once
        return false;
    }
    if (m_now < due) {
        return false;
    }
    due = m_now + period * (1.0 + static_cast<double>(trigger.jitter) *
                                      (2.0 * model::unitDouble(key) - 1.0));
    return true;
}

/// A speed became higher or lower than the limit; what it is at first does not count.
bool RuleEngine::isCrossed(const model::triggers::SpeedLimit& trigger, float speed,
                           Memory& memory) const
{
    const float margin =
        trigger.isAbove != memory.wasThere ? 1.0F + kSpeedMargin : 1.0F - kSpeedMargin;
    const float limit = trigger.metresPerSecond * (memory.isSeen ? margin : 1.0F);
    const bool isThere = trigger.isAbove ? speed > limit : speed < limit;
    const bool wasThere = std::exchange(memory.wasThere, isThere);
    return std::exchange(memory.isSeen, true) && isThere && !wasThere;
}

/// Has stood still for so long; once for each time that he stands.
bool RuleEngine::isTired(const model::triggers::Waited& trigger, float speed, Memory& memory) const
{
    if (speed > kStandsBelow) {
        memory.since = -1.0;
        memory.wasThere = false;
        return false;
    }
    if (memory.since < 0.0) {
        memory.since = m_now;
    }
    return m_now - memory.since >= static_cast<double>(trigger.seconds) &&
           !std::exchange(memory.wasThere, true);
}

/// At the place, or at any where it is 0.
bool RuleEngine::hasArrived(RuleHost& host, std::uint32_t agent, model::PlaceId place) const
{
    const std::uint8_t happened = host.travelEvents()[agent];
    const bool isErrand = (happened & kEndedErrand) != 0;
    const model::PlaceId reached = isErrand ? m_minds[agent].arrived : host.reachedPlace(agent);
    return (isErrand ? reached != 0 : (happened & kReachedPlace) != 0) &&
           (place == 0 || reached == place);
}

/// The place, or any where it is 0.
bool RuleEngine::isInside(RuleHost& host, std::uint32_t agent, model::PlaceId place) const
{
    const glm::vec3 at = host.position(agent);
    return std::ranges::any_of(m_places.places(), [&](const model::Place& each) {
        return (place == 0 || each.id == place) && flatDistance(each.position, at) <= each.radius;
    });
}

bool RuleEngine::happensTo(RuleHost& host, std::uint32_t index, std::uint32_t agent)
{
    using namespace model::triggers;
    Memory& memory = m_memory[index].of[agent];
    return std::visit(
        model::Overloaded{
            [&](const Start&) { return !std::exchange(memory.wasThere, true); },
            [&](const Arrived& each) { return hasArrived(host, agent, each.place); },
            [&](const PathEnded& each) {
                return (host.travelEvents()[agent] & kEndedPath) != 0 &&
                       (each.path == 0 || host.pathOf(agent) == each.path);
            },
            [&](const Entered& each) {
                const bool isThere = isInside(host, agent, each.place);
                return !std::exchange(memory.wasThere, isThere) && isThere;
            },
            [&](const Left& each) {
                const bool isThere = isInside(host, agent, each.place);
                return std::exchange(memory.wasThere, isThere) && !isThere;
            },
            [&](const Every& each) { return isTime(host, index, agent, each); },
            [&](const SpeedLimit& each) { return isCrossed(each, host.speed(agent), memory); },
            [&](const Waited& each) { return isTired(each, host.speed(agent), memory); },
            [](const model::triggers::Event&) { return false; }, // these do not happen to one alone
            [](const ClipEnded&) { return false; }, [](const TagNear&) { return false; },
            [](const AheadFree&) { return false; }},
        m_rules[index].trigger.data);
}

void RuleEngine::lookAt(RuleHost& host, std::uint32_t rule, std::uint32_t agent)
{
    if ((m_bringsBack[rule] || !host.isGone(agent)) && happensTo(host, rule, agent)) {
        fire(host, rule, agent, {});
    }
}

/// At those to whom it can have happened.
void RuleEngine::lookAt(RuleHost& host, std::uint32_t rule)
{
    const model::Trigger& trigger = m_rules[rule].trigger;
    if (trigger.is<model::triggers::Arrived>() || trigger.is<model::triggers::PathEnded>()) {
        for (const std::uint32_t agent : m_happenedTo) {
            lookAt(host, rule, agent);
        }
        return;
    }
    const std::vector<double>& due = m_memory[rule].due;
    const bool isTimed = trigger.is<model::triggers::Every>();
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        if (!isTimed || due[agent] <= m_now) {
            lookAt(host, rule, agent);
        }
    }
}

void RuleEngine::lookForTags(RuleHost& host, std::uint32_t rule,
                             const model::triggers::TagNear& trigger)
{
    const std::uint64_t bit = std::uint64_t{1} << trigger.tag;
    NearCells tagged;
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        if ((m_minds[agent].tags & bit) != 0 && !host.isGone(agent)) {
            tagged.add(agent, host.position(agent));
        }
    }
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        if (host.isGone(agent)) {
            continue;
        }
        const std::uint32_t who = tagged.nearest(host.position(agent), trigger.metres, agent);
        const bool isNear = who != kNone;
        if (std::exchange(m_memory[rule].of[agent].wasThere, isNear) != isNear && isNear) {
            fire(host, rule, agent, {0.0F, host.position(who), true, host.id(who)});
        }
    }
}

/// Once for each time that the place before somebody's gets free; who is busy does it after.
void RuleEngine::lookAhead(RuleHost& host, std::uint32_t rule, model::PathId path)
{
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        const model::PlaceId own = m_minds[agent].holds;
        if (own == 0 || host.isGone(agent)) {
            continue;
        }
        Memory& memory = m_memory[rule].of[agent];
        const bool isFree =
            rooms(host)
                .choose({model::PlaceChoice::Ahead, 0, path}, host.position(agent), own)
                .has_value();
        const bool isKnown = memory.wasThere && memory.place == own;
        memory.place = own;
        memory.wasThere = isFree && (isKnown || fire(host, rule, agent, {}));
    }
}

void RuleEngine::lookAround(RuleHost& host)
{
    for (std::uint32_t rule = 0; rule < m_rules.size(); ++rule) {
        const model::Trigger& trigger = m_rules[rule].trigger;
        if (const auto* near = trigger.as<model::triggers::TagNear>()) {
            lookForTags(host, rule, *near);
        } else if (const auto* ahead = trigger.as<model::triggers::AheadFree>()) {
            lookAhead(host, rule, ahead->path);
        } else if (!trigger.is<model::triggers::Event>() &&
                   !trigger.is<model::triggers::ClipEnded>()) {
            lookAt(host, rule);
        }
    }
}

bool RuleEngine::holds(RuleHost& host, const model::Condition& condition, std::uint64_t key,
                       std::uint32_t agent, const Cause& cause)
{
    using namespace model::conditions;
    const auto isSo = [](float asked, const auto& each) {
        return compares(asked, each.comparison, each.value);
    };
    return std::visit(
        model::Overloaded{
            [&](const HasTag& each) { return (m_minds[agent].tags >> each.tag & 1U) != 0; },
            [&](const OfTemplate& each) { return host.templateOf(agent) == each.templateId; },
            [&](const InPlace& each) {
                return m_places.isInside(each.place, host.position(agent));
            },
            [&](const FollowsPath& each) {
                return each.path == 0 ? host.pathOf(agent) != 0 : host.pathOf(agent) == each.path;
            },
            [&](const IsSeated&) { return host.isSeated(agent); },
            [&](const Chance& each) { return draw(host, agent, key) < each.chance; },
            [&](const Number& each) { return isSo(number(agent, each.number), each); },
            [&](const Speed& each) { return isSo(host.speed(agent), each); },
            [&](const Payload& each) { return isSo(cause.payload, each); },
            [&](const IsFull& each) { return rooms(host).isFull(each.place); },
            [&](const PeopleIn& each) {
                return isSo(static_cast<float>(rooms(host).inside(each.place)), each);
            },
            [&](const Property& each) {
                return each.isClip() ? host.showsClip(agent, each.clip)
                                     : isSo(host.property(agent, each.property), each);
            }},
        condition.data);
}

} // namespace crowd::behavior
