// SPDX-License-Identifier: MIT
#include "widgets/rules/RuleNames.h"

#include <QtCore/QCoreApplication>

namespace crowd::widgets {

using namespace model;

namespace {

struct RuleNamesText
{
    Q_DECLARE_TR_FUNCTIONS(Rules)
};

} // namespace

QString ruleText(const char* text)
{
    return *text == 0 ? QString() : QCoreApplication::translate("Rules", text);
}

QStringList kindNames(std::span<const RuleKind> kinds)
{
    QStringList names;
    for (const RuleKind& kind : kinds) {
        names << ruleText(kind.text.name);
    }
    return names;
}

QStringList kindNamesAlone(std::span<const RuleKind> kinds)
{
    QStringList names;
    for (const RuleKind& kind : kinds) {
        names << ruleText(*kind.text.alone != 0 ? kind.text.alone : kind.text.name);
    }
    return names;
}

QStringList meetingNames()
{
    return {RuleNamesText::tr("interrupts what they do"),
            RuleNamesText::tr("waits until they are free"), RuleNamesText::tr("only who is free")};
}

QStringList yieldNames()
{
    return {RuleNamesText::tr("yields to rules further up"),
            RuleNamesText::tr("yields to any rule"), RuleNamesText::tr("yields to no rule"),
            RuleNamesText::tr("yields to others further up")};
}

QStringList cueReachNames()
{
    return {RuleNamesText::tr("everybody"), RuleNamesText::tr("the selected characters"),
            RuleNamesText::tr("those tagged")};
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
