// SPDX-License-Identifier: MIT
#include "widgets/docks/RuleTexts.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>
#include <QtGui/QColor>

#include "model/scene/RuleSequence.h"

/// Rules as sentences.
namespace crowd::widgets {

using namespace model;

namespace {

struct RuleTextsContext
{
    Q_DECLARE_TR_FUNCTIONS(Rules)
};

QString number(float value)
{
    return QLocale().toString(static_cast<double>(value), 'g', 3);
}

/// What stands for something that is still to be chosen.
QString openText()
{
    return RuleTextsContext::tr("…");
}

/// One that must be chosen: 0 is none.
QString placeText(const Scene& scene, PlaceId id)
{
    const Place* place = scene.findPlace(id);
    return id == 0 || id == kNotChosen ? openText()
                                       : (place != nullptr ? QString::fromStdString(place->name)
                                                           : RuleTextsContext::tr("(gone)"));
}

QString pathText(const Scene& scene, PathId id)
{
    const Path* path = scene.findPath(id);
    return id == 0 || id == kNotChosen ? openText()
                                       : (path != nullptr ? QString::fromStdString(path->name)
                                                          : RuleTextsContext::tr("(gone)"));
}

QString anyPlaceText(const Scene& scene, PlaceId id)
{
    return id == 0 ? RuleTextsContext::tr("any place") : placeText(scene, id);
}

QString anyPathText(const Scene& scene, PathId id)
{
    return id == 0 ? RuleTextsContext::tr("any path") : pathText(scene, id);
}

QString numberText(const Scene& scene, NumberId id)
{
    const auto found = std::ranges::find(scene.numbers, id, &NumberName::id);
    return found != scene.numbers.end()
               ? QString::fromStdString(found->name)
               : (id == 0 ? RuleTextsContext::tr("a number") : RuleTextsContext::tr("(gone)"));
}

QString comparedText(const QString& what, const Condition& condition)
{
    QString text;
    switch (condition.comparison) {
    case Comparison::Less:
        text = condition.isNot ? RuleTextsContext::tr("%1 not below %2")
                               : RuleTextsContext::tr("%1 below %2");
        break;
    case Comparison::Equal:
        text = condition.isNot ? RuleTextsContext::tr("%1 not at %2")
                               : RuleTextsContext::tr("%1 at %2");
        break;
    case Comparison::More:
        text = condition.isNot ? RuleTextsContext::tr("%1 not above %2")
                               : RuleTextsContext::tr("%1 above %2");
        break;
    }
    return text.arg(what, number(condition.value));
}

QString goText(const Scene& scene, const Action& action)
{
    if (action.choice == PlaceChoice::Given) {
        return RuleTextsContext::tr("go to %1").arg(placeText(scene, action.place));
    }
    const QString of =
        action.path != 0    ? RuleTextsContext::tr("of %1").arg(pathText(scene, action.path))
        : action.place != 0 ? RuleTextsContext::tr("named %1").arg(placeText(scene, action.place))
                            : QString();
    QString text;
    switch (action.choice) {
    case PlaceChoice::Given:
        break;
    case PlaceChoice::Nearest:
        text = RuleTextsContext::tr("go to the nearest place %1").arg(of);
        break;
    case PlaceChoice::NearestFree:
        text = RuleTextsContext::tr("go to the nearest free place %1").arg(of);
        break;
    case PlaceChoice::FirstFree:
        text = RuleTextsContext::tr("go to the first free place %1").arg(of);
        break;
    case PlaceChoice::Ahead:
        text = RuleTextsContext::tr("move up to the next free place %1").arg(of);
        break;
    }
    return text.trimmed();
}

/// At which of several exits, or of other places.
QString leaveText(const Scene& scene, const Action& action)
{
    if (action.choice == PlaceChoice::Given) {
        return action.place == 0 ? RuleTextsContext::tr("leave the scene")
                                 : RuleTextsContext::tr("leave the scene at %1")
                                       .arg(placeText(scene, action.place));
    }
    const bool isOfAll = action.path == 0 && action.place == 0;
    const QString of = action.path != 0
                           ? RuleTextsContext::tr("of %1").arg(pathText(scene, action.path))
                           : RuleTextsContext::tr("named %1").arg(placeText(scene, action.place));
    switch (action.choice) {
    case PlaceChoice::Nearest:
        return isOfAll ? RuleTextsContext::tr("leave the scene at the nearest exit")
                       : RuleTextsContext::tr("leave the scene at the nearest place %1").arg(of);
    case PlaceChoice::NearestFree:
        return isOfAll
                   ? RuleTextsContext::tr("leave the scene at the nearest free exit")
                   : RuleTextsContext::tr("leave the scene at the nearest free place %1").arg(of);
    default:
        return isOfAll ? RuleTextsContext::tr("leave the scene at the first free exit")
                       : RuleTextsContext::tr("leave the scene at the first free place %1").arg(of);
    }
}

QString triggerText(const Scene& scene, const Trigger& trigger)
{
    const QString event = QString::fromStdString(trigger.event);
    switch (trigger.kind) {
    case TriggerKind::Start:
        return RuleTextsContext::tr("When it begins");
    case TriggerKind::Event:
        return RuleTextsContext::tr("When “%1” reaches someone").arg(event);
    case TriggerKind::Arrived:
        return RuleTextsContext::tr("When someone arrives at %1")
            .arg(anyPlaceText(scene, trigger.place));
    case TriggerKind::Entered:
        return RuleTextsContext::tr("When someone enters %1")
            .arg(anyPlaceText(scene, trigger.place));
    case TriggerKind::Left:
        return RuleTextsContext::tr("When someone leaves %1")
            .arg(anyPlaceText(scene, trigger.place));
    case TriggerKind::PathEnded:
        return RuleTextsContext::tr("When someone reaches the end of %1")
            .arg(anyPathText(scene, trigger.path));
    case TriggerKind::ClipEnded:
        return RuleTextsContext::tr("When someone’s clip is over");
    case TriggerKind::Every:
        return RuleTextsContext::tr("Every %1 s").arg(number(trigger.seconds));
    case TriggerKind::TagNear:
        return RuleTextsContext::tr("When someone tagged %1 comes within %2 m")
            .arg(tagText(scene, trigger.tag), number(trigger.metres));
    case TriggerKind::SpeedLimit:
        return (trigger.isAbove ? RuleTextsContext::tr("When someone gets faster than %1 m/s")
                                : RuleTextsContext::tr("When someone gets slower than %1 m/s"))
            .arg(number(trigger.metresPerSecond));
    case TriggerKind::Waited:
        return RuleTextsContext::tr("When someone has stood for %1 s").arg(number(trigger.seconds));
    case TriggerKind::AheadFree:
        return trigger.path == 0
                   ? RuleTextsContext::tr("When the place ahead of someone gets free")
                   : RuleTextsContext::tr("When the place ahead of someone in %1 gets free")
                         .arg(pathText(scene, trigger.path));
    }
    return {};
}

/// Of what people are or do, which "not" can stand before.
QString stateText(const Scene& scene, const Condition& condition)
{
    const TemplateEntry* entry = scene.findTemplate(condition.templateId);
    switch (condition.kind) {
    case ConditionKind::HasTag:
        return RuleTextsContext::tr("tagged %1").arg(tagText(scene, condition.tag));
    case ConditionKind::OfTemplate:
        return RuleTextsContext::tr("a %1").arg(entry != nullptr
                                                    ? QString::fromStdString(entry->name)
                                                    : RuleTextsContext::tr("(gone)"));
    case ConditionKind::InPlace:
        return RuleTextsContext::tr("in %1").arg(placeText(scene, condition.place));
    case ConditionKind::FollowsPath:
        return RuleTextsContext::tr("walking %1").arg(anyPathText(scene, condition.path));
    case ConditionKind::IsSeated:
        return RuleTextsContext::tr("seated");
    default:
        return RuleTextsContext::tr("showing %1").arg(QString::fromStdString(condition.clip));
    }
}

QString conditionText(const Scene& scene, const Condition& condition)
{
    switch (condition.kind) {
    case ConditionKind::Chance:
        return (condition.isNot ? RuleTextsContext::tr("except by chance in %1 % of cases")
                                : RuleTextsContext::tr("by chance in %1 % of cases"))
            .arg(number(condition.chance * 100.0F));
    case ConditionKind::Number:
        return comparedText(numberText(scene, condition.number), condition);
    case ConditionKind::Speed:
        return comparedText(RuleTextsContext::tr("speed"), condition);
    case ConditionKind::Payload:
        return comparedText(RuleTextsContext::tr("the event’s number"), condition);
    case ConditionKind::IsFull:
        return (condition.isNot ? RuleTextsContext::tr("%1 not full")
                                : RuleTextsContext::tr("%1 full"))
            .arg(placeText(scene, condition.place));
    case ConditionKind::PeopleIn:
        return comparedText(
            RuleTextsContext::tr("characters in %1").arg(placeText(scene, condition.place)),
            condition);
    case ConditionKind::Property:
        if (condition.property != ComparedProperty::Clip) {
            return comparedText(comparedNames()[static_cast<int>(condition.property)], condition);
        }
        [[fallthrough]];
    default: {
        const QString text = stateText(scene, condition);
        return condition.isNot ? RuleTextsContext::tr("not %1").arg(text) : text;
    }
    }
}

QString clipText(const Action& action)
{
    QStringList names;
    for (const ClipWeight& clip : action.clips) {
        names << QString::fromStdString(clip.clip);
    }
    return names.isEmpty() ? openText() : names.join(RuleTextsContext::tr(" or "));
}

QString reachText(const Scene& scene, const Action& action)
{
    switch (action.reach) {
    case EventReach::Self:
        return RuleTextsContext::tr("themselves");
    case EventReach::Near:
        return RuleTextsContext::tr("those within %1 m").arg(number(action.metres));
    case EventReach::Tagged:
        return RuleTextsContext::tr("those tagged %1").arg(tagText(scene, action.tag));
    case EventReach::Group:
        return RuleTextsContext::tr("their group");
    case EventReach::Everybody:
        return RuleTextsContext::tr("everybody");
    }
    return {};
}

QString aimText(const Scene& scene, const Action& action)
{
    switch (action.aim) {
    case ActionAim::Sender:
        return RuleTextsContext::tr("whoever it came from");
    case ActionAim::Tagged:
        return RuleTextsContext::tr("the nearest one tagged %1").arg(tagText(scene, action.tag));
    case ActionAim::Place:
        return placeText(scene, action.place);
    }
    return {};
}

QString followText(const Scene& scene, const Action& action)
{
    const QString whom = aimText(scene, action);
    return action.seconds > 0.0F
               ? RuleTextsContext::tr("follow %1 for %2 s").arg(whom, number(action.seconds))
               : RuleTextsContext::tr("follow %1 until something else comes").arg(whom);
}

QString lookText(const Scene& scene, const Action& action)
{
    const QString whom = aimText(scene, action);
    return action.seconds > 0.0F
               ? RuleTextsContext::tr("look at %1 for %2 s").arg(whom, number(action.seconds))
               : RuleTextsContext::tr("look at %1 until something else comes").arg(whom);
}

QString propertyText(const Action& action)
{
    switch (action.property) {
    case SettableProperty::Tint: {
        const QString color = QColor(action.tint.red, action.tint.green, action.tint.blue).name();
        return action.slot.empty() ? RuleTextsContext::tr("turn %1").arg(color)
                                   : RuleTextsContext::tr("turn %1 at %2")
                                         .arg(color, QString::fromStdString(action.slot));
    }
    case SettableProperty::Height:
        return RuleTextsContext::tr("become %1 × as tall").arg(number(action.value));
    case SettableProperty::PlaybackSpeed:
        return RuleTextsContext::tr("move %1 × as fast").arg(number(action.value));
    case SettableProperty::Clip:
        return RuleTextsContext::tr("from now on %1").arg(clipText(action));
    case SettableProperty::Phase:
        return RuleTextsContext::tr("go to %1 of their clip").arg(number(action.value));
    }
    return {};
}

QString actionText(const Scene& scene, const Action& action)
{
    switch (action.kind) {
    case ActionKind::PlayClip:
        return RuleTextsContext::tr("play %1").arg(clipText(action));
    case ActionKind::FollowPath:
        return RuleTextsContext::tr("walk along %1").arg(pathText(scene, action.path));
    case ActionKind::GoToPlace:
        return goText(scene, action);
    case ActionKind::Flee:
        return action.aim == ActionAim::Sender
                   ? RuleTextsContext::tr("run %1 m away").arg(number(action.metres))
                   : RuleTextsContext::tr("run %1 m away from %2")
                         .arg(number(action.metres), aimText(scene, action));
    case ActionKind::Stop:
        return RuleTextsContext::tr("stop");
    case ActionKind::GoOn:
        return RuleTextsContext::tr("walk on");
    case ActionKind::Wait:
        return RuleTextsContext::tr("wait about %1 s").arg(number(action.seconds));
    case ActionKind::SetSpeed:
        return action.value > 0.0F ? RuleTextsContext::tr("at %1 m/s").arg(number(action.value))
                                   : RuleTextsContext::tr("at the event’s speed");
    case ActionKind::TurnTo:
        return RuleTextsContext::tr("turn to %1").arg(aimText(scene, action));
    case ActionKind::AddTag:
        return RuleTextsContext::tr("tag %1").arg(tagText(scene, action.tag));
    case ActionKind::RemoveTag:
        return RuleTextsContext::tr("untag %1").arg(tagText(scene, action.tag));
    case ActionKind::SendEvent:
        return RuleTextsContext::tr("send “%1” to %2")
            .arg(QString::fromStdString(action.event), reachText(scene, action));
    case ActionKind::LeaveScene:
        return leaveText(scene, action);
    case ActionKind::Again:
        return RuleTextsContext::tr("do it again");
    case ActionKind::SitDown:
        return action.metres > 0.0F
                   ? RuleTextsContext::tr("sit on the nearest free seat within %1 m")
                         .arg(number(action.metres))
                   : RuleTextsContext::tr("sit on the nearest free seat");
    case ActionKind::StandUp:
        return RuleTextsContext::tr("stand up");
    case ActionKind::WaitForEvent: {
        const QString event = QString::fromStdString(action.event);
        return action.seconds > 0.0F ? RuleTextsContext::tr("wait for “%1”, at most %2 s")
                                           .arg(event, number(action.seconds))
                                     : RuleTextsContext::tr("wait for “%1”").arg(event);
    }
    case ActionKind::SetNumber:
        return RuleTextsContext::tr("set %1 to %2")
            .arg(numberText(scene, action.number), number(action.value));
    case ActionKind::AddToNumber:
        return RuleTextsContext::tr("add %1 to %2")
            .arg(number(action.value), numberText(scene, action.number));
    case ActionKind::Appear:
        return RuleTextsContext::tr("appear at %1").arg(placeText(scene, action.place));
    case ActionKind::GoToPerson:
        return RuleTextsContext::tr("go to %1").arg(aimText(scene, action));
    case ActionKind::Follow:
        return followText(scene, action);
    case ActionKind::LookAt:
        return lookText(scene, action);
    case ActionKind::SetProperty:
        return propertyText(action);
    case ActionKind::Repeat:
        return action.times == 0
                   ? RuleTextsContext::tr("repeat for ever")
                   : RuleTextsContext::tr("repeat %1 ×").arg(QLocale().toString(action.times));
    case ActionKind::OneOf:
        return RuleTextsContext::tr("one of these");
    }
    return {};
}

QString sequenceText(const Scene& scene, const Actions& actions, std::size_t begin,
                     std::size_t end);

QString blockText(const Scene& scene, const Actions& actions, std::size_t head)
{
    const std::size_t end = endOf(actions, head);
    return end == head + 1
               ? RuleTextsContext::tr("nothing")
               : RuleTextsContext::tr("(%1)").arg(sequenceText(scene, actions, head + 1, end));
}

/// "either (…) 70 % or (…) 30 %".
QString choiceText(const Scene& scene, const Actions& actions,
                   const std::vector<std::size_t>& lines)
{
    float total = 0.0F;
    for (const std::size_t line : lines) {
        total += actions[line].weight;
    }
    QStringList texts;
    for (const std::size_t line : lines) {
        const float share = total > 0.0F ? actions[line].weight / total : 0.0F;
        texts << RuleTextsContext::tr("%1 %2 %").arg(
            blockText(scene, actions, line), QLocale().toString(std::lround(100.0F * share)));
    }
    return RuleTextsContext::tr("either %1").arg(texts.join(RuleTextsContext::tr(" or ")));
}

/// What is done line by line, with what belongs to each.
QString sequenceText(const Scene& scene, const Actions& actions, std::size_t begin, std::size_t end)
{
    QStringList texts;
    for (std::size_t line = begin; line < end;) {
        const Action& action = actions[line];
        if (action.kind == ActionKind::OneOf) {
            const std::vector<std::size_t> lines = alternativesOf(actions, line);
            texts << choiceText(scene, actions, lines);
            line = endOf(actions, lines.back());
            continue;
        }
        texts << (action.kind == ActionKind::Repeat
                      ? RuleTextsContext::tr("%1 %2").arg(actionText(scene, action),
                                                          blockText(scene, actions, line))
                      : actionText(scene, action));
        line = endOf(actions, line);
    }
    return texts.join(RuleTextsContext::tr(", then "));
}

} // namespace

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
        when = RuleTextsContext::tr("%1, %2").arg(
            when, conditions.join(rule.isAnyEnough ? RuleTextsContext::tr(" or ")
                                                   : RuleTextsContext::tr(" and ")));
    }
    return RuleTextsContext::tr("%1: %2").arg(
        when, sequenceText(scene, rule.actions, 0, rule.actions.size()));
}

} // namespace crowd::widgets
