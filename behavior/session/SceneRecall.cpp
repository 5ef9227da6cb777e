// SPDX-License-Identifier: MIT
#include "behavior/session/SceneRecall.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "behavior/session/PoseCapture.h"
#include "behavior/session/SceneAdoption.h"

namespace crowd::behavior {

namespace {

namespace recalledKeys = model::columns;

/// Where the scene has them, wherever the run has led them meanwhile.
void placeAnew(SessionParts& parts, const model::ChangeOver& change)
{
    const model::Population& people = parts.population;
    MotionState& motion = parts.agents.motion;
    const bool isPlace = change.columns.contains(model::ColumnId::Position);
    for (const model::IndividualId id : change.ids) {
        const std::size_t row = people.rowOf(id);
        if (row == model::Population::npos || parts.agents.isGone[row] != 0) {
            continue; // who has left the scene is out of everybody's way
        }
        const auto agent = static_cast<std::uint32_t>(row);
        if (isPlace) {
            motion.put(agent, people.column(recalledKeys::position)[row]);
            motion.speed[agent] = 0.0F;
        }
        if (change.columns.contains(model::ColumnId::Heading)) {
            motion.heading[agent] = people.column(recalledKeys::heading)[row];
        }
        if (change.columns.contains(model::ColumnId::Seat) &&
            parts.agents.seatPhase[agent] != SeatPhase::None) {
            parts.seating.setSeat(agent, people.column(recalledKeys::seat)[row], false);
        }
    }
    if (isPlace) {
        parts.resetBodies(people);
    }
}

/// `changed`: whom rules hear of. Whoever has it of a rule is free for others when its line is
/// done.
void changeOver(SessionParts& parts, const model::ChangeOver& change,
                const model::Population& shown, std::span<const model::IndividualId> changed,
                bool isOfRule)
{
    placeAnew(parts, change);
    forgetRuleValues(parts, change.ids, change.columns);
    parts.fades.forget(change);
    const model::CrowdFrame after = captureFrame(parts);
    const double now = parts.clock.seconds();
    const std::vector<float> delays = delaysOf(change, parts.lastScene, shown);
    parts.fades.begin(change, delays, shown, after.population, now);
    const double heard = now + static_cast<double>(isOfRule ? parts.clock.stepSeconds : 0.0F);
    for (std::size_t i = 0; i < change.ids.size() && !parts.rules.isEmpty(); ++i) {
        if (std::ranges::binary_search(changed, change.ids[i])) {
            parts.dueRecalls.push_back(
                {heard + static_cast<double>(delays[i]), change.ids[i], change.state});
        }
    }
}

/// `isOfRule`: who is like that already does not hear of it again, so that no rule can call itself
/// for ever.
model::StateRecall recall(SessionParts& parts, const model::ChangeOver& change, bool isOfRule)
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
    changeOver(parts, change, shown, isOfRule ? done.changed : change.ids, isOfRule);
    return done;
}

bool isOneRecall(const RuleRecall& a, const RuleRecall& b)
{
    return a.action == b.action;
}

} // namespace

void forgetRuleValues(SessionParts& parts, std::span<const model::IndividualId> ids,
                      const model::ColumnSet& columns)
{
    for (const model::IndividualId id : ids) {
        const std::size_t row = parts.population.rowOf(id);
        if (row == model::Population::npos) {
            continue;
        }
        const auto agent = static_cast<std::uint32_t>(row);
        columns.forEach([&](model::ColumnId column) { parts.idle.forget(agent, column); });
        if (columns.contains(model::ColumnId::Clip) && parts.animation.isPlaying(agent)) {
            parts.animation.endClip(agent);
        }
        if (columns.contains(model::ColumnId::Tags)) {
            parts.rules.setTags(agent, parts.population.column(recalledKeys::tags)[row]);
        }
        if (columns.contains(model::ColumnId::Height)) {
            parts.agents.height[agent] = parts.population.column(recalledKeys::height)[row];
        }
    }
    parts.shownOverrides = parts.overrides.publish();
}

void adoptRecall(SessionParts& parts, const model::Scene& scene, const model::ChangeOver& change)
{
    const model::Population shown = captureFrame(parts).population;
    adoptScene(parts, scene, false);
    changeOver(parts, change, shown, change.ids, false);
}

model::StateRecall recallInSession(SessionParts& parts, const model::ChangeOver& change)
{
    return recall(parts, change, false);
}

void recallForRules(SessionParts& parts)
{
    std::vector<RuleRecall> all = std::exchange(parts.ruleRecalls, {});
    while (!all.empty()) {
        const RuleRecall first = all.front();
        const auto others =
            std::stable_partition(all.begin(), all.end(), [&first](const RuleRecall& each) {
                return isOneRecall(first, each);
            });
        model::ChangeOver change{first.action.state, {}, {}, {first.action.seconds, {}}};
        change.timing.stagger.seconds = first.action.within;
        change.timing.stagger.order = model::StaggerOrder::Random;
        for (auto each = all.begin(); each != others; ++each) {
            change.ids.push_back(each->id);
        }
        all.erase(all.begin(), others);
        std::ranges::sort(change.ids);
        change.ids.erase(std::unique(change.ids.begin(), change.ids.end()), change.ids.end());
        for (const model::State& state : parts.lastScene.states) {
            change.columns = state.id == change.state ? state.columns : change.columns;
        }
        (void)recall(parts, change, true);
    }
}

void tellRulesOfRecalls(SessionParts& parts)
{
    const double now = parts.clock.seconds();
    std::erase_if(parts.dueRecalls, [&](const DueRecall& due) {
        const std::size_t row =
            due.begin <= now ? parts.population.rowOf(due.id) : model::Population::npos;
        if (row != model::Population::npos) {
            parts.rules.noteRecalled(static_cast<std::uint32_t>(row), due.state);
        }
        return due.begin <= now;
    });
}

} // namespace crowd::behavior
