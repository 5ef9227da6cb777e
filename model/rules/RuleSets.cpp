// SPDX-License-Identifier: MIT
#include "model/rules/RuleSets.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <QtCore/QCoreApplication>

namespace crowd::model {

namespace {

struct Names
{
    Q_DECLARE_TR_FUNCTIONS(RuleSets)
};

constexpr float kOverAnAisle = 2.8F;  ///< metres from a seat to the next one beyond it
constexpr float kCalmSeconds = 20.0F; ///< before who has fled can panic again
constexpr float kNoEcho = 6.5F;       ///< seconds after which nobody near passes a call on any more

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
    rule.trigger = triggers::Event{event};
    return rule;
}

Action play(std::vector<ClipWeight> clips, float seconds)
{
    return actions::PlayClip{std::move(clips), true, seconds};
}

Action wait(float seconds)
{
    return actions::Wait{seconds};
}

Action setSpeed(float metresPerSecond)
{
    return actions::SetSpeed{metresPerSecond};
}

Action flee(float metres)
{
    actions::Flee flee;
    flee.metres = metres;
    return flee;
}

Action passOn(const char* event, float metres, float secondsPerMetre)
{
    actions::SendEvent send;
    send.event = event;
    send.metres = metres;
    send.secondsPerMetre = secondsPerMetre;
    return send;
}

Condition chance(float share)
{
    return conditions::Chance{share};
}

/// At where they are, or at the nearest exit.
Action leave(PlaceChoice choice = PlaceChoice::Given)
{
    actions::LeaveScene leave;
    leave.choice = choice;
    return leave;
}

/// The latest call wins, whichever it is.
void letOthersInterrupt(Rule& rule)
{
    rule.meeting = RuleMeeting::Interrupt;
    rule.yields = RuleYield::Anybody;
}

/// One rule for those who sit and one for those who stand. For 0 seconds: until something else.
std::vector<Rule> reaction(const Scene& scene, const char* event, const QString& name,
                           float seconds)
{
    std::vector<Rule> rules;
    for (const bool isSeated : {true, false}) {
        Rule rule = onEvent(event, isSeated ? Names::tr("%1, seated").arg(name) : name);
        rule.conditions = {{conditions::IsSeated(), !isSeated}, chance(0.85F)};
        rule.actions = {passOn(event, kOverAnAisle, 0.35F), wait(0.3F),
                        play(clipsLike(scene, event, isSeated), seconds)};
        rule.cooldownSeconds = kNoEcho;
        letOthersInterrupt(rule);
        rules.push_back(std::move(rule));
    }
    return rules;
}

/// Whoever is called breaks off what the others let him do, and is as he was before.
Rule calm()
{
    Rule rule = onEvent("calm", Names::tr("All calm down"));
    rule.actions = {passOn("calm", kOverAnAisle, 0.2F)};
    rule.cooldownSeconds = kNoEcho;
    letOthersInterrupt(rule);
    return rule;
}

/// Most are left out where no template has a clip for them.
std::vector<Rule> audience(const Scene& scene)
{
    struct Reaction
    {
        const char* event;
        QString name;
        float seconds;
        bool waitsForClips = false; ///< there also where no template has a clip for it yet
    };
    const Reaction reactions[]{{"clap", Names::tr("Applause spreads"), 6.0F, true},
                               {"cheer", Names::tr("Cheers spread"), 6.0F, true},
                               {"wave", Names::tr("Waving spreads"), 6.0F},
                               {"sad", Names::tr("Sadness spreads"), 0.0F},
                               {"bored", Names::tr("Boredom spreads"), 0.0F},
                               {"angry", Names::tr("Anger spreads"), 0.0F}};
    std::vector<Rule> rules;
    for (const Reaction& each : reactions) {
        for (Rule& rule : reaction(scene, each.event, each.name, each.seconds)) {
            if (each.waitsForClips || !rule.actions.back().as<actions::PlayClip>()->clips.empty()) {
                rules.push_back(std::move(rule));
            }
        }
    }
    rules.push_back(calm());
    return rules;
}

/// Up and down again, and on to those beside.
std::vector<Rule> wave(const Scene& scene)
{
    std::vector<Rule> rules = reaction(scene, "wave", Names::tr("The wave runs on"), 1.6F);
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
    run.actions = {actions::GoOn(), setSpeed(0.0F)};
    Rule walk = onEvent("walk", Names::tr("Walk on"));
    walk.actions = {actions::GoOn(), setSpeed(kUsualWalkingSpeed)};
    Rule stop = onEvent("stop", Names::tr("Stop until told to walk"));
    stop.actions = {actions::Stop()};
    Rule look;
    look.name = named(Names::tr("Some stop and look around"));
    look.trigger = triggers::Every{20.0F, 0.5F};
    look.conditions = {chance(0.15F)};
    look.actions = {actions::Stop(), wait(3.0F), actions::GoOn()};
    look.meeting = RuleMeeting::Ignore;
    return {run, walk, stop, look};
}

std::vector<Rule> panic()
{
    Rule rule = onEvent("panic", Names::tr("Flee, tell others, leave"));
    rule.actions = {passOn("panic", 3.0F, 0.15F), setSpeed(3.0F), flee(8.0F),
                    leave(PlaceChoice::Nearest)};
    rule.cooldownSeconds = kCalmSeconds;
    return {rule};
}

std::vector<Rule> flock()
{
    Rule wander;
    wander.name = named(Names::tr("Wander about"));
    wander.trigger = triggers::Every{9.0F, 0.7F};
    wander.actions = {setSpeed(0.8F), flee(4.0F)};
    wander.meeting = RuleMeeting::Ignore;
    Rule startle = onEvent("startle", Names::tr("Run from what startles"));
    startle.actions = {passOn("startle", 4.0F, 0.1F), setSpeed(4.0F), flee(14.0F)};
    startle.cooldownSeconds = 6.0F;
    return {startle, wander};
}

Action goTo(PlaceChoice choice, PathId path)
{
    actions::GoToPlace go;
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
    join.yields = RuleYield::Others; // whoever is called again keeps his place
    Rule serve;
    serve.name = named(Names::tr("Be served, then leave"));
    serve.trigger =
        triggers::Arrived{line != scene.paths.end() ? line->places.front() : kNotChosen};
    const bool hasExit =
        std::ranges::find(scene.places, PlaceRole::Exit, &Place::role) != scene.places.end();
    serve.actions = {wait(4.0F), leave(hasExit ? PlaceChoice::Nearest : PlaceChoice::Given)};
    serve.yields = RuleYield::Nobody;
    Rule moveUp;
    moveUp.name = named(Names::tr("Move up"));
    moveUp.trigger = triggers::AheadFree{path};
    moveUp.actions = {wait(0.5F), goTo(PlaceChoice::Ahead, path)};
    moveUp.meeting = RuleMeeting::Ignore;
    return {moveUp, join, serve};
}

using CueText = std::string; // lupdate takes std:: before a function for its context

/// What a button says for an event of the sets; empty: as the event is called.
CueText cueName(const std::string& event)
{
    const std::pair<const char*, QString> names[]{
        {"clap", Names::tr("Applause")},       {"cheer", Names::tr("Cheers")},
        {"wave", Names::tr("Wave")},           {"sad", Names::tr("Sad")},
        {"bored", Names::tr("Bored")},         {"angry", Names::tr("Angry")},
        {"calm", Names::tr("Calm")},           {"run", Names::tr("Run")},
        {"walk", Names::tr("Walk")},           {"stop", Names::tr("Stop")},
        {"panic", Names::tr("Panic")},         {"startle", Names::tr("Startle")},
        {"queue", Names::tr("Line up", "cue")}};
    const auto found = std::ranges::find(names, event, [](const auto& each) { return each.first; });
    return found == std::end(names) ? CueText() : named(found->second);
}

/// Everybody, but where it is to begin with some.
CueReach reachOf(RuleSet set)
{
    return set == RuleSet::StadiumWave || set == RuleSet::Queue ? CueReach::Selected
                                                                : CueReach::Everybody;
}

bool isSent(const std::vector<Cue>& cues, const std::string& event)
{
    return std::ranges::find(cues, event, &Cue::event) != cues.end();
}

/// With the next id and, as long as there are any, a key of its own.
/// Its id is that of none that the timeline still calls.
Cue cueOf(const std::string& event, const std::vector<Cue>& others, const Timeline& timeline)
{
    Cue cue;
    cue.id = 1;
    for (const Cue& each : others) {
        cue.id = std::max(cue.id, each.id + 1);
    }
    for (const Mark& mark : timeline) {
        cue.id = std::max(cue.id, mark.cue + 1);
    }
    const auto free = std::ranges::find_if(kCueKeys, [&](std::string_view key) {
        return std::ranges::find(others, key, &Cue::key) == others.end();
    });
    cue.key = free == kCueKeys.end() ? std::string() : std::string(*free);
    cue.event = event;
    return cue;
}

std::vector<std::string> eventsOf(const std::vector<Rule>& rules)
{
    std::vector<std::string> events;
    for (const Rule& rule : rules) {
        const auto* event = rule.trigger.as<triggers::Event>();
        if (event != nullptr && std::ranges::find(events, event->event) == events.end()) {
            events.push_back(event->event);
        }
    }
    return events;
}

} // namespace

std::vector<Rule> rulesOf(RuleSet set, const Scene& scene)
{
    switch (set) {
    case RuleSet::Audience:
        return audience(scene);
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
    return eventsOf(scene.rules);
}

std::vector<Cue> cuesWith(RuleSet set, const std::vector<Rule>& rules, const Scene& scene)
{
    std::vector<Cue> cues = scene.cues;
    for (const std::string& event : eventsOf(rules)) {
        if (cues.size() < kMaxNamed && !isSent(cues, event)) {
            cues.push_back(cueOf(event, cues, scene.timeline));
            cues.back().name = cueName(event);
            cues.back().reach = reachOf(set);
        }
    }
    return cues;
}

Cue nextCue(const Scene& scene)
{
    const std::vector<std::string> events = eventsOf(scene);
    const auto unsent = std::ranges::find_if(
        events, [&](const std::string& event) { return !isSent(scene.cues, event); });
    const std::string usual = events.empty() ? std::string("cheer") : events.front();
    return cueOf(unsent != events.end() ? *unsent : usual, scene.cues, scene.timeline);
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
