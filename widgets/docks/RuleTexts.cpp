// SPDX-License-Identifier: MIT
#include "widgets/docks/RuleTexts.h"

#include <algorithm>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

namespace crowd::widgets {

using namespace model;

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Rules)
};

QString number(float value)
{
    return QLocale().toString(static_cast<double>(value), 'g', 3);
}

QString placeText(const Scene& scene, PlaceId id)
{
    const Place* place = scene.findPlace(id);
    return id == 0 ? Text::tr("any place")
                   : (place != nullptr ? QString::fromStdString(place->name) : Text::tr("(gone)"));
}

QString pathText(const Scene& scene, PathId id)
{
    const Path* path = scene.findPath(id);
    return id == 0 ? Text::tr("any path")
                   : (path != nullptr ? QString::fromStdString(path->name) : Text::tr("(gone)"));
}

QString triggerText(const Scene& scene, const Trigger& trigger)
{
    const QString event = QString::fromStdString(trigger.event);
    switch (trigger.kind) {
    case TriggerKind::Start:
        return Text::tr("When it begins");
    case TriggerKind::Event:
        return Text::tr("When “%1” reaches someone").arg(event);
    case TriggerKind::Arrived:
        return Text::tr("When someone arrives at %1").arg(placeText(scene, trigger.place));
    case TriggerKind::Entered:
        return Text::tr("When someone enters %1").arg(placeText(scene, trigger.place));
    case TriggerKind::Left:
        return Text::tr("When someone leaves %1").arg(placeText(scene, trigger.place));
    case TriggerKind::PathEnded:
        return Text::tr("When someone reaches the end of %1").arg(pathText(scene, trigger.path));
    case TriggerKind::ClipEnded:
        return Text::tr("When someone’s clip is over");
    case TriggerKind::Every:
        return Text::tr("Every %1 s").arg(number(trigger.seconds));
    case TriggerKind::TagNear:
        return Text::tr("When someone tagged %1 comes within %2 m")
            .arg(tagText(scene, trigger.tag), number(trigger.metres));
    }
    return {};
}

QString conditionText(const Scene& scene, const Condition& condition)
{
    const TemplateEntry* entry = scene.findTemplate(condition.templateId);
    QString text;
    switch (condition.kind) {
    case ConditionKind::HasTag:
        text = Text::tr("tagged %1").arg(tagText(scene, condition.tag));
        break;
    case ConditionKind::OfTemplate:
        text = Text::tr("a %1").arg(entry != nullptr ? QString::fromStdString(entry->name)
                                                     : Text::tr("(gone)"));
        break;
    case ConditionKind::InPlace:
        text = Text::tr("in %1").arg(placeText(scene, condition.place));
        break;
    case ConditionKind::FollowsPath:
        text = Text::tr("walking %1").arg(pathText(scene, condition.path));
        break;
    case ConditionKind::IsSeated:
        text = Text::tr("seated");
        break;
    case ConditionKind::Chance:
        text = Text::tr("with %1 % chance").arg(number(condition.chance * 100.0F));
        break;
    }
    return condition.isNot ? Text::tr("not %1").arg(text) : text;
}

QString clipText(const Action& action)
{
    QStringList names;
    for (const ClipWeight& clip : action.clips) {
        names << QString::fromStdString(clip.clip);
    }
    return names.join(Text::tr(" or "));
}

QString reachText(const Scene& scene, const Action& action)
{
    switch (action.reach) {
    case EventReach::Self:
        return Text::tr("themselves");
    case EventReach::Near:
        return Text::tr("those within %1 m").arg(number(action.metres));
    case EventReach::Tagged:
        return Text::tr("those tagged %1").arg(tagText(scene, action.tag));
    case EventReach::Group:
        return Text::tr("their group");
    case EventReach::Everybody:
        return Text::tr("everybody");
    }
    return {};
}

QString actionText(const Scene& scene, const Action& action)
{
    switch (action.kind) {
    case ActionKind::PlayClip:
        return Text::tr("play %1").arg(clipText(action));
    case ActionKind::FollowPath:
        return Text::tr("walk along %1").arg(pathText(scene, action.path));
    case ActionKind::GoToPlace:
        return Text::tr("go to %1").arg(placeText(scene, action.place));
    case ActionKind::Flee:
        return Text::tr("run %1 m away").arg(number(action.metres));
    case ActionKind::Stop:
        return Text::tr("stop");
    case ActionKind::GoOn:
        return Text::tr("walk on");
    case ActionKind::Wait:
        return Text::tr("wait %1 s").arg(number(action.seconds));
    case ActionKind::SetSpeed:
        return action.value > 0.0F ? Text::tr("at %1 m/s").arg(number(action.value))
                                   : Text::tr("at the event’s speed");
    case ActionKind::TurnTo:
        return action.place != 0 ? Text::tr("turn to %1").arg(placeText(scene, action.place))
                                 : Text::tr("turn to where it came from");
    case ActionKind::AddTag:
        return Text::tr("tag %1").arg(tagText(scene, action.tag));
    case ActionKind::RemoveTag:
        return Text::tr("untag %1").arg(tagText(scene, action.tag));
    case ActionKind::SendEvent:
        return Text::tr("send “%1” to %2")
            .arg(QString::fromStdString(action.event), reachText(scene, action));
    case ActionKind::LeaveScene:
        return Text::tr("leave the scene");
    case ActionKind::Again:
        return Text::tr("do it again");
    }
    return {};
}

QString actionProblem(const Scene& scene, const Action& action)
{
    const bool isGoing = action.kind == ActionKind::GoToPlace;
    if ((isGoing || (action.kind == ActionKind::TurnTo && action.place != 0)) &&
        scene.findPlace(action.place) == nullptr) {
        return Text::tr("The place is not there any more: choose another one.");
    }
    if (action.kind == ActionKind::FollowPath && scene.findPath(action.path) == nullptr) {
        return Text::tr("The path is not there any more: choose another one.");
    }
    if (action.kind == ActionKind::PlayClip) {
        const bool isAny = std::ranges::any_of(action.clips, [&](const ClipWeight& clip) {
            return std::ranges::any_of(scene.templates, [&](const TemplateEntry& entry) {
                return std::ranges::find(entry.clipNames, clip.clip) != entry.clipNames.end();
            });
        });
        if (!isAny) {
            return Text::tr("Nobody has a clip to play: choose one.");
        }
    }
    if (action.kind == ActionKind::SendEvent && action.event.empty()) {
        return Text::tr("The event to send has no name: type one.");
    }
    return {};
}

} // namespace

QStringList triggerNames()
{
    return {
        Text::tr("it begins"),      Text::tr("an event comes"), Text::tr("someone arrives at"),
        Text::tr("someone enters"), Text::tr("someone leaves"), Text::tr("a path ends"),
        Text::tr("a clip is over"), Text::tr("every so often"), Text::tr("someone tagged is near")};
}

QStringList conditionNames()
{
    return {Text::tr("tagged"),       Text::tr("of template"), Text::tr("inside place"),
            Text::tr("walking path"), Text::tr("seated"),      Text::tr("by chance")};
}

QStringList actionNames()
{
    return {Text::tr("play a clip"),
            Text::tr("walk along a path"),
            Text::tr("go to a place"),
            Text::tr("run away"),
            Text::tr("stop"),
            Text::tr("walk on"),
            Text::tr("wait"),
            Text::tr("set the speed"),
            Text::tr("turn to"),
            Text::tr("tag"),
            Text::tr("untag"),
            Text::tr("send an event"),
            Text::tr("leave the scene"),
            Text::tr("do it again")};
}

QStringList reachNames()
{
    return {Text::tr("themselves"), Text::tr("those near"), Text::tr("those tagged"),
            Text::tr("their group"), Text::tr("everybody")};
}

QStringList meetingNames()
{
    return {Text::tr("interrupts what they do"), Text::tr("waits until they are free"),
            Text::tr("only who is free")};
}

QString ruleSetName(RuleSet set)
{
    switch (set) {
    case RuleSet::Audience:
        return Text::tr("Audience Reactions");
    case RuleSet::StadiumWave:
        return Text::tr("Stadium Wave");
    case RuleSet::Pedestrians:
        return Text::tr("Pedestrians");
    case RuleSet::Panic:
        return Text::tr("Panic and Exit");
    case RuleSet::Flock:
        return Text::tr("Flock of Animals");
    case RuleSet::Count:
        break;
    }
    return {};
}

QString tagText(const Scene& scene, std::uint8_t tag)
{
    const auto named = std::ranges::find(scene.tags, tag, &TagName::bit);
    return named != scene.tags.end() && !named->name.empty() ? QString::fromStdString(named->name)
                                                             : QString::number(tag + 1);
}

QString ruleSentence(const Scene& scene, const Rule& rule)
{
    QString when = triggerText(scene, rule.trigger);
    QStringList conditions;
    for (const Condition& condition : rule.conditions) {
        conditions << conditionText(scene, condition);
    }
    if (!conditions.isEmpty()) {
        when = Text::tr("%1, %2").arg(
            when, conditions.join(rule.isAnyEnough ? Text::tr(" or ") : Text::tr(" and ")));
    }
    QStringList actions;
    for (const Action& action : rule.actions) {
        actions << actionText(scene, action);
    }
    return Text::tr("%1: %2").arg(when, actions.join(Text::tr(", then ")));
}

QString ruleProblem(const Scene& scene, const Rule& rule)
{
    const Trigger& trigger = rule.trigger;
    if (trigger.kind == TriggerKind::Event && trigger.event.empty()) {
        return Text::tr("The event has no name: type one.");
    }
    const bool isPlace = trigger.kind == TriggerKind::Arrived ||
                         trigger.kind == TriggerKind::Entered || trigger.kind == TriggerKind::Left;
    if (isPlace && trigger.place != 0 && scene.findPlace(trigger.place) == nullptr) {
        return Text::tr("The place is not there any more: choose another one.");
    }
    if (trigger.kind == TriggerKind::PathEnded && trigger.path != 0 &&
        scene.findPath(trigger.path) == nullptr) {
        return Text::tr("The path is not there any more: choose another one.");
    }
    for (const Condition& condition : rule.conditions) {
        const bool isGone = (condition.kind == ConditionKind::InPlace &&
                             scene.findPlace(condition.place) == nullptr) ||
                            (condition.kind == ConditionKind::FollowsPath && condition.path != 0 &&
                             scene.findPath(condition.path) == nullptr) ||
                            (condition.kind == ConditionKind::OfTemplate &&
                             scene.findTemplate(condition.templateId) == nullptr);
        if (isGone) {
            return Text::tr("A condition asks for something that is not there: choose again.");
        }
    }
    if (rule.actions.empty()) {
        return Text::tr("It does nothing yet: add something to do.");
    }
    for (const Action& action : rule.actions) {
        const QString problem = actionProblem(scene, action);
        if (!problem.isEmpty()) {
            return problem;
        }
    }
    return {};
}

} // namespace crowd::widgets
