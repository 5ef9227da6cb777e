// SPDX-License-Identifier: MIT
#include "behavior/rules/RuleConditions.h"

#include <algorithm>
#include <cmath>

#include "behavior/rules/RelatedAgents.h"
#include "model/base/Overloaded.h"
#include "model/base/Random.h"

namespace crowd::behavior {

namespace {

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

/// For kinds that compare a number with a value.
template<class Kind>
bool compares(float asked, const Kind& condition)
{
    return compares(asked, condition.comparison, condition.value);
}

} // namespace

bool isTrue(const RuleScope& scope, const model::Condition& condition, std::uint64_t key,
            std::uint32_t agent, const TriggerContext& context)
{
    using namespace model::conditions;
    const RuleHost& host = scope.host;
    const RuleState& state = scope.state;
    return std::visit(
        model::Overloaded{
            [&](const HasTag& each) { return state.agents.hasTag(agent, each.tag); },
            [&](const HasFeature& each) { return host.bears(agent, each.feature); },
            [&](const OfTemplate& each) { return host.templateOf(agent) == each.templateId; },
            [&](const InPlace& each) {
                return state.places.isInside(each.place, host.position(agent));
            },
            [&](const FollowsPath& each) {
                return each.path == 0 ? host.pathOf(agent) != 0 : host.pathOf(agent) == each.path;
            },
            [&](const IsSeated&) { return host.isSeated(agent); },
            [&](const Chance& each) { return draw(scope, agent, key) < each.chance; },
            [&](const Number& each) {
                return compares(state.numbers.value(agent, each.number), each);
            },
            [&](const Speed& each) { return compares(host.speed(agent), each); },
            [&](const Payload& each) { return compares(context.payload, each); },
            [&](const IsFull& each) { return countedPlaces(scope).isFull(each.place); },
            [&](const PeopleIn& each) {
                return compares(static_cast<float>(countedPlaces(scope).inside(each.place)), each);
            },
            [&](const Related& each) {
                const auto others = relatedAgents(state, agent, each.relation);
                const auto here = std::ranges::count_if(
                    others, [&host](std::uint32_t other) { return !host.isGone(other); });
                return compares(static_cast<float>(here), each);
            },
            [&](const Property& each) {
                return each.isClip() ? host.showsClip(agent, each.clip)
                                     : compares(host.property(agent, each.property), each);
            }},
        condition.data);
}

bool conditionsHold(const RuleScope& scope, const model::Rule& rule, std::uint32_t agent,
                    const TriggerContext& context)
{
    bool isAny = rule.conditions.empty();
    bool areAll = true;
    for (std::size_t i = 0; i < rule.conditions.size(); ++i) {
        const model::Condition& condition = rule.conditions[i];
        const std::uint64_t key = model::hashKeys(rule.id, i, 61);
        const bool isSo = isTrue(scope, condition, key, agent, context) != condition.isNot;
        isAny = isAny || isSo;
        areAll = areAll && isSo;
    }
    return rule.isAnyEnough ? isAny : areAll;
}

} // namespace crowd::behavior
