// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "behavior/motion/TravelEvents.h"
#include "behavior/rules/RuleEngine.h"
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

bool RuleEngine::isTime(RuleHost& host, std::uint32_t index, std::uint32_t agent)
{
    const model::Trigger& trigger = m_rules[index].trigger;
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
bool RuleEngine::isCrossed(const model::Trigger& trigger, float speed, Memory& memory) const
{
    const float margin =
        trigger.isAbove != memory.wasThere ? 1.0F + kSpeedMargin : 1.0F - kSpeedMargin;
    const float limit = trigger.metresPerSecond * (memory.isSeen ? margin : 1.0F);
    const bool isThere = trigger.isAbove ? speed > limit : speed < limit;
    const bool wasThere = std::exchange(memory.wasThere, isThere);
    return std::exchange(memory.isSeen, true) && isThere && !wasThere;
}

/// Has stood still for so long; once for each time that he stands.
bool RuleEngine::isTired(const model::Trigger& trigger, float speed, Memory& memory) const
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

bool RuleEngine::happensTo(RuleHost& host, std::uint32_t index, std::uint32_t agent)
{
    const model::Trigger& trigger = m_rules[index].trigger;
    Memory& memory = m_memory[index].of[agent];
    const std::uint8_t happened = host.travelEvents()[agent];
    switch (trigger.kind) {
    case model::TriggerKind::Start:
        return !std::exchange(memory.wasThere, true);
    case model::TriggerKind::Arrived: {
        const bool isErrand = (happened & kEndedErrand) != 0;
        const model::PlaceId reached = isErrand ? m_minds[agent].arrived : host.reachedPlace(agent);
        return (isErrand ? reached != 0 : (happened & kReachedPlace) != 0) &&
               (trigger.place == 0 || reached == trigger.place);
    }
    case model::TriggerKind::PathEnded:
        return (happened & kEndedPath) != 0 &&
               (trigger.path == 0 || host.pathOf(agent) == trigger.path);
    case model::TriggerKind::Entered:
    case model::TriggerKind::Left: {
        const glm::vec3 at = host.position(agent);
        const bool isThere = std::ranges::any_of(m_places.places(), [&](const model::Place& place) {
            return (trigger.place == 0 || place.id == trigger.place) &&
                   flatDistance(place.position, at) <= place.radius;
        });
        const bool wasThere = std::exchange(memory.wasThere, isThere);
        return trigger.kind == model::TriggerKind::Entered ? isThere && !wasThere
                                                           : wasThere && !isThere;
    }
    case model::TriggerKind::Every:
        return isTime(host, index, agent);
    case model::TriggerKind::SpeedLimit:
        return isCrossed(trigger, host.speed(agent), memory);
    case model::TriggerKind::Waited:
        return isTired(trigger, host.speed(agent), memory);
    case model::TriggerKind::Event:
    case model::TriggerKind::ClipEnded:
    case model::TriggerKind::TagNear:
    case model::TriggerKind::AheadFree:
        break;
    }
    return false;
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
    const model::TriggerKind kind = m_rules[rule].trigger.kind;
    if (kind == model::TriggerKind::Arrived || kind == model::TriggerKind::PathEnded) {
        for (const std::uint32_t agent : m_happenedTo) {
            lookAt(host, rule, agent);
        }
        return;
    }
    const std::vector<double>& due = m_memory[rule].due;
    const bool isTimed = kind == model::TriggerKind::Every;
    for (std::uint32_t agent = 0; agent < m_minds.size(); ++agent) {
        if (!isTimed || due[agent] <= m_now) {
            lookAt(host, rule, agent);
        }
    }
}

void RuleEngine::lookForTags(RuleHost& host, std::uint32_t rule)
{
    const model::Trigger trigger = m_rules[rule].trigger;
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
void RuleEngine::lookAhead(RuleHost& host, std::uint32_t rule)
{
    const model::PathId path = m_rules[rule].trigger.path;
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
        const model::TriggerKind kind = m_rules[rule].trigger.kind;
        if (kind == model::TriggerKind::TagNear) {
            lookForTags(host, rule);
        } else if (kind == model::TriggerKind::AheadFree) {
            lookAhead(host, rule);
        } else if (kind != model::TriggerKind::Event && kind != model::TriggerKind::ClipEnded) {
            lookAt(host, rule);
        }
    }
}

bool RuleEngine::holds(RuleHost& host, const model::Condition& condition, std::uint64_t key,
                       std::uint32_t agent, const Cause& cause)
{
    const auto isSo = [&condition](float asked) {
        return compares(asked, condition.comparison, condition.value);
    };
    switch (condition.kind) {
    case model::ConditionKind::HasTag:
        return (m_minds[agent].tags >> condition.tag & 1U) != 0;
    case model::ConditionKind::OfTemplate:
        return host.templateOf(agent) == condition.templateId;
    case model::ConditionKind::InPlace:
        return m_places.isInside(condition.place, host.position(agent));
    case model::ConditionKind::FollowsPath:
        return condition.path == 0 ? host.pathOf(agent) != 0 : host.pathOf(agent) == condition.path;
    case model::ConditionKind::IsSeated:
        return host.isSeated(agent);
    case model::ConditionKind::Chance:
        return draw(host, agent, key) < condition.chance;
    case model::ConditionKind::Number:
        return isSo(number(agent, condition.number));
    case model::ConditionKind::Speed:
        return isSo(host.speed(agent));
    case model::ConditionKind::Payload:
        return isSo(cause.payload);
    case model::ConditionKind::IsFull:
        return rooms(host).isFull(condition.place);
    case model::ConditionKind::PeopleIn:
        return isSo(static_cast<float>(rooms(host).inside(condition.place)));
    case model::ConditionKind::Property:
        return condition.property == model::ComparedProperty::Clip
                   ? host.showsClip(agent, condition.clip)
                   : isSo(host.property(agent, condition.property));
    }
    return false;
}

} // namespace crowd::behavior
