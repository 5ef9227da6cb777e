// SPDX-License-Identifier: MIT
#include <QtCore/QCoreApplication>

#include "widgets/docks/RuleTexts.h"

/// What can be chosen in a rule, by name.
namespace crowd::widgets {

using namespace model;

namespace {

struct RuleNamesText
{
    Q_DECLARE_TR_FUNCTIONS(Rules)
};

} // namespace

QStringList triggerNames()
{
    return {RuleNamesText::tr("it begins"),
            RuleNamesText::tr("an event comes"),
            RuleNamesText::tr("someone arrives at"),
            RuleNamesText::tr("someone enters"),
            RuleNamesText::tr("someone leaves"),
            RuleNamesText::tr("a path ends"),
            RuleNamesText::tr("a clip is over"),
            RuleNamesText::tr("every so often"),
            RuleNamesText::tr("someone tagged is near"),
            RuleNamesText::tr("a speed is passed"),
            RuleNamesText::tr("someone has stood for"),
            RuleNamesText::tr("the place ahead gets free")};
}

QStringList conditionNames()
{
    return {RuleNamesText::tr("tagged"),
            RuleNamesText::tr("of template"),
            RuleNamesText::tr("inside place"),
            RuleNamesText::tr("walking path"),
            RuleNamesText::tr("seated"),
            RuleNamesText::tr("by chance"),
            RuleNamesText::tr("own number"),
            RuleNamesText::tr("speed"),
            RuleNamesText::tr("event’s number"),
            RuleNamesText::tr("full: the place"),
            RuleNamesText::tr("number of characters in"),
            RuleNamesText::tr("property")};
}

QStringList verbsOf(ConditionKind kind)
{
    return kind == ConditionKind::Chance
               ? QStringList{RuleNamesText::tr("happens"), RuleNamesText::tr("does not happen")}
               : QStringList{RuleNamesText::tr("is"), RuleNamesText::tr("is not")};
}

QStringList actionNames()
{
    return {RuleNamesText::tr("play a clip"),
            RuleNamesText::tr("walk along a path"),
            RuleNamesText::tr("go to a place"),
            RuleNamesText::tr("run away"),
            RuleNamesText::tr("stop"),
            RuleNamesText::tr("walk on"),
            RuleNamesText::tr("wait"),
            RuleNamesText::tr("set the speed"),
            RuleNamesText::tr("turn to"),
            RuleNamesText::tr("tag"),
            RuleNamesText::tr("untag"),
            RuleNamesText::tr("send an event"),
            RuleNamesText::tr("leave the scene"),
            RuleNamesText::tr("do it again"),
            RuleNamesText::tr("sit on a free seat"),
            RuleNamesText::tr("stand up"),
            RuleNamesText::tr("wait for an event"),
            RuleNamesText::tr("set a number"),
            RuleNamesText::tr("add to a number"),
            RuleNamesText::tr("appear at a place"),
            RuleNamesText::tr("go to someone"),
            RuleNamesText::tr("follow someone"),
            RuleNamesText::tr("look at"),
            RuleNamesText::tr("change a property"),
            RuleNamesText::tr("repeat"),
            RuleNamesText::tr("one of these")};
}

QStringList reachNames()
{
    return {RuleNamesText::tr("themselves"), RuleNamesText::tr("those near"),
            RuleNamesText::tr("those tagged"), RuleNamesText::tr("their group"),
            RuleNamesText::tr("everybody")};
}

QStringList meetingNames()
{
    return {RuleNamesText::tr("interrupts what they do"),
            RuleNamesText::tr("waits until they are free"), RuleNamesText::tr("only who is free")};
}

QStringList yieldNames()
{
    return {RuleNamesText::tr("yields to rules further up"),
            RuleNamesText::tr("yields to any rule"), RuleNamesText::tr("yields to no rule")};
}

QStringList comparisonNames()
{
    return {RuleNamesText::tr("below"), RuleNamesText::tr("at"), RuleNamesText::tr("above")};
}

QStringList choiceNames()
{
    return {RuleNamesText::tr("this place"), RuleNamesText::tr("the nearest"),
            RuleNamesText::tr("the nearest free one"), RuleNamesText::tr("the first free one"),
            RuleNamesText::tr("the one ahead, when free")};
}

QStringList cueReachNames()
{
    return {RuleNamesText::tr("everybody"), RuleNamesText::tr("the selected characters"),
            RuleNamesText::tr("those tagged")};
}

QStringList comparedNames()
{
    return {RuleNamesText::tr("height"), RuleNamesText::tr("girth"),
            RuleNamesText::tr("playback speed"), RuleNamesText::tr("walking speed"),
            RuleNamesText::tr("clip")};
}

QStringList settableNames()
{
    return {RuleNamesText::tr("colour"), RuleNamesText::tr("height"),
            RuleNamesText::tr("playback speed"), RuleNamesText::tr("clip while at rest"),
            RuleNamesText::tr("place in that clip")};
}

QStringList aimNames()
{
    return {RuleNamesText::tr("whoever it came from"), RuleNamesText::tr("the nearest with"),
            RuleNamesText::tr("a place")};
}

QString ruleSetName(RuleSet set)
{
    switch (set) {
    case RuleSet::Audience:
        return RuleNamesText::tr("Audience Reactions");
    case RuleSet::StadiumWave:
        return RuleNamesText::tr("Stadium Wave");
    case RuleSet::Pedestrians:
        return RuleNamesText::tr("Pedestrians");
    case RuleSet::Panic:
        return RuleNamesText::tr("Panic and Exit");
    case RuleSet::Flock:
        return RuleNamesText::tr("Flock of Animals");
    case RuleSet::Queue:
        return RuleNamesText::tr("Queue");
    case RuleSet::Count:
        break;
    }
    return {};
}

} // namespace crowd::widgets
