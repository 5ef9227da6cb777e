// SPDX-License-Identifier: MIT
#include "behavior/session/SceneRecall.h"

#include <algorithm>

#include "behavior/session/PoseCapture.h"
#include "behavior/session/SceneAdoption.h"

namespace crowd::behavior {

namespace {

namespace recalledKeys = model::columns;

/// What rules have set of these properties counts no more, nor the clip that they let somebody
/// play.
void forgetRules(SessionParts& parts, const model::ChangeOver& change)
{
    for (const model::IndividualId id : change.ids) {
        const std::size_t row = parts.population.rowOf(id);
        if (row == model::Population::npos) {
            continue;
        }
        const auto agent = static_cast<std::uint32_t>(row);
        change.columns.forEach([&](model::ColumnId column) { parts.idle.forget(agent, column); });
        if (change.columns.contains(model::ColumnId::Clip) && parts.animation.isPlaying(agent)) {
            parts.animation.endClip(agent);
        }
        if (change.columns.contains(model::ColumnId::Tags)) {
            parts.rules.setTags(agent, parts.population.column(recalledKeys::tags)[row]);
        }
        if (change.columns.contains(model::ColumnId::Height)) {
            parts.agents.height[agent] = parts.population.column(recalledKeys::height)[row];
        }
    }
    parts.shownOverrides = parts.overrides.publish();
}

void changeOver(SessionParts& parts, const model::ChangeOver& change,
                const model::Population& shown)
{
    forgetRules(parts, change);
    parts.fades.forget(change);
    const model::CrowdFrame after = captureFrame(parts);
    parts.fades.begin(change, parts.lastScene, shown, after.population, parts.clock.seconds());
}

} // namespace

void adoptRecall(SessionParts& parts, const model::Scene& scene, const model::ChangeOver& change)
{
    const model::Population shown = captureFrame(parts).population;
    adoptScene(parts, scene, false);
    changeOver(parts, change, shown);
}

model::StateRecall recallInSession(SessionParts& parts, const model::ChangeOver& change)
{
    const auto& states = parts.lastScene.states;
    const auto state = std::ranges::find(states, change.state, &model::State::id);
    if (state == states.end()) {
        return {};
    }
    const model::Population shown = captureFrame(parts).population;
    model::Scene recalled = parts.lastScene;
    recalled.population = parts.population;
    model::StateRecall done = recallState(recalled, *state, change.columns, &change.ids);
    parts.recalled.take(parts.lastScene.population, recalled.population,
                        recalledColumns(*state, change.columns));
    adoptPeople(parts, parts.lastScene, recalled.population, false);
    changeOver(parts, change, shown);
    return done;
}

} // namespace crowd::behavior
