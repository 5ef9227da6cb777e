// SPDX-License-Identifier: MIT
#include "model/scene/RuleSets.h"

#include <algorithm>
#include <string_view>

#include <QtCore/QCoreApplication>

namespace crowd::model {

namespace {

struct Names
{
    Q_DECLARE_TR_FUNCTIONS(RuleSets)
};

constexpr float kOverAnAisle = 2.8F; ///< metres from a seat to the next one beyond it

std::string named(const QString& text)
{
    return text.toStdString();
}

/// Clips of the scene's templates whose names hold the word, each once: those to sit with or the
/// others.
std::vector<ClipWeight> clipsLike(const Scene& scene, std::string_view word, bool isSeated)
{
    std::vector<ClipWeight> clips;
    for (const TemplateEntry& entry : scene.templates) {
        for (const std::string& name : entry.clipNames) {
            const bool fits = name.find(word) != std::string::npos &&
                              (name.find("sit") != std::string::npos) == isSeated;
            if (fits && std::ranges::find(clips, name, &ClipWeight::clip) == clips.end()) {
                clips.push_back({name, 1.0F});
            }
        }
    }
    return clips;
}

Rule onEvent(const char* event, const QString& name)
{
    Rule rule;
    rule.name = named(name);
    rule.trigger.kind = TriggerKind::Event;
    rule.trigger.event = event;
    return rule;
}

Action play(std::vector<ClipWeight> clips, float seconds)
{
    Action action;
    action.kind = ActionKind::PlayClip;
    action.clips = std::move(clips);
    action.isLooped = true;
    action.seconds = seconds;
    return action;
}

Action action(ActionKind kind, float value = 0.0F)
{
    Action made;
    made.kind = kind;
    made.value = value;
    made.metres = value;
    made.seconds = value;
    return made;
}

Action passOn(const char* event, float metres, float secondsPerMetre)
{
    Action made;
    made.kind = ActionKind::SendEvent;
    made.event = event;
    made.reach = EventReach::Near;
    made.metres = metres;
    made.secondsPerMetre = secondsPerMetre;
    return made;
}

Condition chance(float share)
{
    Condition condition;
    condition.kind = ConditionKind::Chance;
    condition.chance = share;
    return condition;
}

/// One rule for those who sit and one for those who stand.
std::vector<Rule> reaction(const Scene& scene, const char* event, const QString& name)
{
    std::vector<Rule> rules;
    for (const bool isSeated : {true, false}) {
        Rule rule = onEvent(event, isSeated ? Names::tr("%1, seated").arg(name) : name);
        Condition seated;
        seated.kind = ConditionKind::IsSeated;
        seated.isNot = !isSeated;
        rule.conditions = {seated, chance(0.85F)};
        rule.actions = {passOn(event, kOverAnAisle, 0.35F), action(ActionKind::Wait, 0.3F),
                        play(clipsLike(scene, event, isSeated), 6.0F)};
        rule.cooldownSeconds = 8.0F;
        rule.meeting = RuleMeeting::Ignore;
        rules.push_back(std::move(rule));
    }
    return rules;
}

/// Up and down again, and on to those beside.
std::vector<Rule> wave(const Scene& scene)
{
    std::vector<Rule> rules = reaction(scene, "wave", Names::tr("The wave runs on"));
    for (Rule& rule : rules) {
        const bool isSeated = !rule.conditions.front().isNot;
        rule.conditions.resize(1);
        std::vector<ClipWeight> clips = clipsLike(scene, isSeated ? "cheer" : "wave", isSeated);
        rule.actions = {passOn("wave", 2.2F, 0.12F), play(clips, 1.6F)};
        rule.cooldownSeconds = 10.0F;
    }
    return rules;
}

std::vector<Rule> pedestrians()
{
    Rule run = onEvent("run", Names::tr("Run at the number's speed"));
    run.actions = {action(ActionKind::GoOn), action(ActionKind::SetSpeed)};
    Rule walk = onEvent("walk", Names::tr("Walk on"));
    walk.actions = {action(ActionKind::GoOn), action(ActionKind::SetSpeed, kUsualWalkingSpeed)};
    Rule stop = onEvent("stop", Names::tr("Stop until told to walk"));
    stop.actions = {action(ActionKind::Stop)};
    Rule look;
    look.name = named(Names::tr("Some stop and look around"));
    look.trigger.kind = TriggerKind::Every;
    look.trigger.seconds = 20.0F;
    look.trigger.jitter = 0.5F;
    look.conditions = {chance(0.15F)};
    look.actions = {action(ActionKind::Stop), action(ActionKind::Wait, 3.0F),
                    action(ActionKind::GoOn)};
    look.meeting = RuleMeeting::Ignore;
    return {run, walk, stop, look};
}

std::vector<Rule> panic()
{
    Rule rule = onEvent("panic", Names::tr("Flee, tell others, leave"));
    rule.actions = {passOn("panic", 3.0F, 0.15F), action(ActionKind::SetSpeed, 3.0F),
                    action(ActionKind::Flee, 8.0F)};
    rule.limit = 1;
    Action leave = action(ActionKind::LeaveScene); // at an exit that is painted later, too
    leave.choice = PlaceChoice::Nearest;
    rule.actions.push_back(leave);
    return {rule};
}

std::vector<Rule> flock()
{
    Rule wander;
    wander.name = named(Names::tr("Wander about"));
    wander.trigger.kind = TriggerKind::Every;
    wander.trigger.seconds = 9.0F;
    wander.trigger.jitter = 0.7F;
    wander.actions = {action(ActionKind::SetSpeed, 0.8F), action(ActionKind::Flee, 4.0F)};
    wander.meeting = RuleMeeting::Ignore;
    Rule startle = onEvent("startle", Names::tr("Run from what startles"));
    startle.actions = {passOn("startle", 4.0F, 0.1F), action(ActionKind::SetSpeed, 4.0F),
                       action(ActionKind::Flee, 14.0F)};
    startle.cooldownSeconds = 6.0F;
    return {startle, wander};
}

Action goTo(PlaceChoice choice, PathId path)
{
    Action go = action(ActionKind::GoToPlace);
    go.choice = choice;
    go.path = path;
    return go;
}

/// On the places of the first path, its first place in front; without one there is still to choose.
std::vector<Rule> queue(const Scene& scene)
{
    const auto line =
        std::ranges::find_if(scene.paths, [](const Path& path) { return path.places.size() > 1; });
    const PathId path = line != scene.paths.end() ? line->id : kNotChosen;
    Rule join = onEvent("queue", Names::tr("Line up"));
    join.actions = {goTo(PlaceChoice::FirstFree, path)};
    join.meeting = RuleMeeting::Ignore;
    Rule serve;
    serve.name = named(Names::tr("Be served, then leave"));
    serve.trigger.kind = TriggerKind::Arrived;
    serve.trigger.place = line != scene.paths.end() ? line->places.front() : kNotChosen;
    serve.actions = {action(ActionKind::Wait, 4.0F), action(ActionKind::LeaveScene)};
    const auto exit = std::ranges::find(scene.places, PlaceRole::Exit, &Place::role);
    if (exit != scene.places.end()) {
        serve.actions.back().choice = PlaceChoice::Nearest;
    }
    serve.yields = RuleYield::Nobody;
    Rule moveUp;
    moveUp.name = named(Names::tr("Move up"));
    moveUp.trigger.kind = TriggerKind::AheadFree;
    moveUp.trigger.path = path;
    moveUp.actions = {action(ActionKind::Wait, 0.5F), goTo(PlaceChoice::Ahead, path)};
    moveUp.meeting = RuleMeeting::Ignore;
    return {join, serve, moveUp};
}

} // namespace

std::vector<Rule> rulesOf(RuleSet set, const Scene& scene)
{
    switch (set) {
    case RuleSet::Audience: {
        std::vector<Rule> rules = reaction(scene, "clap", Names::tr("Applause spreads"));
        const std::vector<Rule> cheer = reaction(scene, "cheer", Names::tr("Cheers spread"));
        rules.insert(rules.end(), cheer.begin(), cheer.end());
        return rules;
    }
    case RuleSet::StadiumWave:
        return wave(scene);
    case RuleSet::Pedestrians:
        return pedestrians();
    case RuleSet::Panic:
        return panic();
    case RuleSet::Flock:
        return flock();
    case RuleSet::Queue:
        return queue(scene);
    case RuleSet::Count:
        break;
    }
    return {};
}

std::vector<std::string> eventsOf(const Scene& scene)
{
    std::vector<std::string> events;
    for (const Rule& rule : scene.rules) {
        if (rule.trigger.kind == TriggerKind::Event &&
            std::ranges::find(events, rule.trigger.event) == events.end()) {
            events.push_back(rule.trigger.event);
        }
    }
    return events;
}

void giveIds(std::vector<Rule>& rules, const Scene& scene)
{
    RuleId next = 1;
    for (const Rule& rule : scene.rules) {
        next = std::max(next, rule.id + 1);
    }
    for (Rule& rule : rules) {
        rule.id = next++;
    }
}

} // namespace crowd::model
