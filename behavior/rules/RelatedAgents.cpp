// SPDX-License-Identifier: MIT
#include "behavior/rules/RelatedAgents.h"

#include <algorithm>
#include <limits>

#include "model/base/Random.h"

namespace crowd::behavior {

namespace {

constexpr std::size_t kMostHeard = 16; ///< names of events that somebody remembers
constexpr std::uint32_t kMostPasses = 1000;
constexpr std::uint64_t kPassDelay = 91; ///< purpose of draws

bool passes(const model::RelationKinds& kinds, const model::RelationLink& link)
{
    const model::RelationKind* kind = findRelation(kinds, link.kind);
    return kind != nullptr && kind->passesEvents && (kind->isMutual || link.isOut);
}

double callOf(const QueuedEvent& event)
{
    return event.calledAt < 0.0 ? event.due : event.calledAt;
}

} // namespace

std::vector<std::uint32_t> relatedAgents(const RuleState& state, std::uint32_t agent,
                                         std::uint32_t relation)
{
    std::vector<std::uint32_t> found;
    for (const model::RelationLink& link : state.relations.of(state.agents.ids()[agent])) {
        const std::uint32_t other = state.agents.agentNamed(link.other);
        if ((relation == 0 || link.kind == relation) && other != kNoAgent) {
            found.push_back(other);
        }
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::uint32_t nearestRelated(const RuleScope& scope, std::uint32_t agent, std::uint32_t relation)
{
    std::uint32_t nearest = kNoAgent;
    float best = std::numeric_limits<float>::max();
    const glm::vec3 at = scope.host.position(agent);
    for (const std::uint32_t other : relatedAgents(scope.state, agent, relation)) {
        const float away = flatDistance(scope.host.position(other), at);
        if (!scope.host.isGone(other) && away < best) {
            nearest = other;
            best = away;
        }
    }
    return nearest;
}

bool areRelated(const RuleState& state, std::uint32_t agent, std::uint32_t other,
                std::uint32_t relation)
{
    const model::IndividualId id = state.agents.ids()[other];
    return std::ranges::any_of(state.relations.of(state.agents.ids()[agent]),
                               [id, relation](const model::RelationLink& link) {
                                   return link.other == id &&
                                          (relation == 0 || link.kind == relation);
                               });
}

bool hearsFirst(RuleState& state, std::uint32_t agent, const QueuedEvent& event)
{
    if (state.relations.isEmpty()) {
        return true;
    }
    std::vector<HeardCall>& heard = state.agents[agent].heard;
    const std::uint64_t name = model::hashText(event.name);
    const auto known = std::ranges::find(heard, name, &HeardCall::event);
    const bool isNew = known == heard.end() || known->calledAt < callOf(event);
    if (known == heard.end()) {
        if (heard.size() >= kMostHeard) {
            heard.erase(heard.begin());
        }
        heard.push_back({name, callOf(event)});
    } else if (isNew) {
        known->calledAt = callOf(event);
    }
    return isNew;
}

void passOn(const RuleScope& scope, std::uint32_t agent, const QueuedEvent& event)
{
    RuleState& state = scope.state;
    if (state.relations.isEmpty() || event.passes >= kMostPasses) {
        return;
    }
    const model::IndividualId id = state.agents.ids()[agent];
    for (const model::RelationLink& link : state.relations.of(id)) {
        if (!passes(state.relationKinds, link) || state.events.isFull()) {
            continue;
        }
        const model::ValueRange& seconds =
            findRelation(state.relationKinds, link.kind)->passSeconds;
        const float share = model::unitFloat(model::hashKeys(
            state.seed, id, link.other, state.clock.step, model::hashText(event.name), kPassDelay));
        QueuedEvent next = event;
        next.due =
            event.due + static_cast<double>(seconds.low + (seconds.high - seconds.low) * share);
        next.receiver = link.other;
        next.sender = id;
        next.origin = scope.host.position(agent);
        next.calledAt = callOf(event);
        next.passes = event.passes + 1;
        state.events.post(std::move(next));
    }
}

} // namespace crowd::behavior
