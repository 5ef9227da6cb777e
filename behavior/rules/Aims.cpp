// SPDX-License-Identifier: MIT
#include "behavior/rules/Aims.h"

#include "behavior/rules/RelatedAgents.h"

namespace crowd::behavior {

std::optional<Aim> aimOf(const ActionScope& scope, const model::AimChoice& choice)
{
    const TriggerContext& context = scope.self().context;
    const AgentStates& agents = scope.state.agents;
    std::uint32_t whom = kNoAgent;
    switch (choice.aim) {
    case model::ActionAim::Sender:
        whom = context.sender != 0 ? agents.agentNamed(context.sender) : kNoAgent;
        if (whom == kNoAgent || scope.host.isGone(whom)) {
            return context.hasOrigin ? std::optional(Aim{context.origin, kNoAgent}) : std::nullopt;
        }
        break;
    case model::ActionAim::Tagged:
        whom = scope.state.people.nearestTagged(scope.host, agents, scope.agent, choice.tag);
        break;
    case model::ActionAim::Related:
        whom = nearestRelated(RuleScope{scope.state, scope.host}, scope.agent, choice.relation);
        break;
    case model::ActionAim::Place:
        if (const model::Place* place = scope.state.places.find(choice.place)) {
            return Aim{place->position, kNoAgent};
        }
        scope.report(QT_TRANSLATE_NOOP(
            "Messages",
            "Rule \"%1\" names a place that is not there any more. Choose another one."));
        break;
    }
    return whom == kNoAgent ? std::nullopt : std::optional(Aim{scope.host.position(whom), whom});
}

} // namespace crowd::behavior
