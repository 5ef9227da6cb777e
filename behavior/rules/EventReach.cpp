// SPDX-License-Identifier: MIT
#include "behavior/rules/EventReach.h"

#include "behavior/rules/RelatedAgents.h"

namespace crowd::behavior {

const std::vector<std::uint32_t>* candidatesOf(const RuleScope& scope, std::uint32_t sender,
                                               const model::actions::SendEvent& action)
{
    PeopleIndex& people = scope.state.people;
    switch (action.reach) {
    case model::EventReach::Self:
        return &people.only(sender);
    case model::EventReach::Near:
        return people.near(scope.host, sender, action.metres);
    case model::EventReach::Tagged:
        return &people.withTag(scope.state.agents, action.tag);
    case model::EventReach::Group:
        return &people.inGroup(scope.host, scope.host.group(sender));
    case model::EventReach::Related:
        return &people.these(relatedAgents(scope.state, sender, action.relation));
    case model::EventReach::Everybody:
        break;
    }
    return nullptr;
}

bool reaches(const RuleScope& scope, std::uint32_t sender, std::uint32_t other,
             const model::actions::SendEvent& action)
{
    const RuleHost& host = scope.host;
    if (action.reach == model::EventReach::Self) {
        return other == sender;
    }
    if (other == sender) {
        return false;
    }
    switch (action.reach) {
    case model::EventReach::Near:
        return !host.isGone(other) &&
               flatDistance(host.position(other), host.position(sender)) <= action.metres;
    case model::EventReach::Tagged:
        return scope.state.agents.hasTag(other, action.tag);
    case model::EventReach::Group:
        return host.group(other) == host.group(sender);
    case model::EventReach::Self:
    case model::EventReach::Everybody:
    case model::EventReach::Related: // candidates are no others
        break;
    }
    return true;
}

} // namespace crowd::behavior
