// SPDX-License-Identifier: MIT
#include <algorithm>

#include <QtCore/QCoreApplication>

#include "model/scene/RuleFlaws.h"
#include "model/scene/RuleSequence.h"
#include "widgets/docks/RuleTexts.h"

/// What is wrong with rules as they stand.
namespace crowd::widgets {

using namespace model;

namespace {

struct RuleProblemsText
{
    Q_DECLARE_TR_FUNCTIONS(Rules)
};

QString blockProblem(const Actions& actions, std::size_t line)
{
    if (actions[line].kind == ActionKind::Repeat && endOf(actions, line) == line + 1) {
        return RuleProblemsText::tr("There is nothing to repeat: press “+ in it”.");
    }
    if (actions[line].kind != ActionKind::OneOf) {
        return {};
    }
    const std::vector<std::size_t> lines = alternativesOf(actions, line);
    const bool isAny =
        std::ranges::any_of(lines, [&](std::size_t each) { return actions[each].weight > 0.0F; });
    if (lines.size() < 2) {
        return RuleProblemsText::tr("There is only one to choose: press “+ or…” for another.");
    }
    return isAny ? QString()
                 : RuleProblemsText::tr("None of them ever comes: let one come more often.");
}

bool hasNumber(const Scene& scene, NumberId id)
{
    return std::ranges::find(scene.numbers, id, &NumberName::id) != scene.numbers.end();
}

bool hasSlot(const Scene& scene, const std::string& name)
{
    return std::ranges::any_of(scene.templates, [&](const TemplateEntry& entry) {
        return !entry.asset || entry.asset->slotIndex(name) >= 0; // who is not there may have it
    });
}

/// Whether an action names a place that must be there.
bool needsPlace(const Action& action)
{
    switch (action.kind) {
    case ActionKind::GoToPlace:
        return action.choice == PlaceChoice::Given || (action.path == 0 && action.place != 0);
    case ActionKind::Appear:
        return true;
    case ActionKind::Flee:
    case ActionKind::TurnTo:
    case ActionKind::LookAt:
        return action.aim == ActionAim::Place;
    case ActionKind::LeaveScene:
        return action.path == 0 && action.place != 0;
    default:
        return false;
    }
}

bool needsPath(const Action& action)
{
    return action.kind == ActionKind::FollowPath ||
           ((action.kind == ActionKind::GoToPlace || action.kind == ActionKind::LeaveScene) &&
            action.choice != PlaceChoice::Given && action.path != 0);
}

QString actionProblem(const Scene& scene, const Action& action)
{
    if (needsPlace(action) && scene.findPlace(action.place) == nullptr) {
        return RuleProblemsText::tr("The place is not there any more: choose another one.");
    }
    if (needsPath(action) && scene.findPath(action.path) == nullptr) {
        return RuleProblemsText::tr("The path is not there any more: choose another one.");
    }
    const bool isOnNumber =
        action.kind == ActionKind::SetNumber || action.kind == ActionKind::AddToNumber;
    if (isOnNumber && !hasNumber(scene, action.number)) {
        return RuleProblemsText::tr(
            "The number is not there: make one below, under “Tags and numbers”.");
    }
    const bool isToPerson =
        action.kind == ActionKind::GoToPerson || action.kind == ActionKind::Follow;
    if (isToPerson && action.aim == ActionAim::Place) {
        return RuleProblemsText::tr("A place is nobody to go after: choose whom.");
    }
    if (action.kind == ActionKind::SetProperty && action.property == SettableProperty::Tint &&
        !action.slot.empty() && !hasSlot(scene, action.slot)) {
        return RuleProblemsText::tr("Nobody has a slot of that name: choose one.");
    }
    const bool isClip =
        action.kind == ActionKind::SetProperty && action.property == SettableProperty::Clip;
    if (action.kind == ActionKind::PlayClip || isClip) {
        const bool isAny = std::ranges::any_of(action.clips, [&](const ClipWeight& clip) {
            return std::ranges::any_of(scene.templates, [&](const TemplateEntry& entry) {
                return std::ranges::find(entry.clipNames, clip.clip) != entry.clipNames.end();
            });
        });
        if (!isAny) {
            return RuleProblemsText::tr("Nobody has a clip to play: choose one.");
        }
    }
    return {};
}

/// What is still to be chosen, so that it does nothing yet.
QString gapText(RuleGap gap)
{
    switch (gap) {
    case RuleGap::Event:
        return RuleProblemsText::tr("It does nothing yet: type the event that it waits for.");
    case RuleGap::SentEvent:
        return RuleProblemsText::tr("It does nothing yet: type the event to send.");
    case RuleGap::AwaitedEvent:
        return RuleProblemsText::tr("It does nothing yet: type the event to wait for.");
    case RuleGap::Clip:
        return RuleProblemsText::tr("It does nothing yet: choose a clip.");
    case RuleGap::Place:
        return RuleProblemsText::tr("It does nothing yet: choose a place.");
    case RuleGap::Path:
        return RuleProblemsText::tr("It does nothing yet: choose a path.");
    case RuleGap::Number:
        return RuleProblemsText::tr("It does nothing yet: choose a number; make one below, under "
                                    "“Tags and numbers”.");
    case RuleGap::Template:
        return RuleProblemsText::tr("It does nothing yet: choose a template.");
    case RuleGap::Deed:
        return RuleProblemsText::tr("It does nothing yet: add something to do.");
    }
    return {};
}

QString flawText(const Scene& scene, const RuleFlaw& flaw)
{
    const auto found = std::ranges::find(scene.rules, flaw.other, &Rule::id);
    const QString other =
        found == scene.rules.end() ? QString() : QString::fromStdString(found->name);
    switch (flaw.kind) {
    case RuleFlawKind::Unfinished:
        return gapText(flaw.gap);
    case RuleFlawKind::NeverTrue:
        return RuleProblemsText::tr(
            "It never comes: its conditions exclude each other. Remove one of them.");
    case RuleFlawKind::Hidden:
        return RuleProblemsText::tr("It never comes: “%1” above it comes at the same occasion. Let "
                                    "this one wait until they are free, or give one of them a "
                                    "condition.")
            .arg(other);
    case RuleFlawKind::BrokenOff:
        return RuleProblemsText::tr("It gets nothing done: “%1” breaks it off at once. Let one of "
                                    "them wait until they are free, or give it a condition.")
            .arg(other);
    case RuleFlawKind::Undone:
        return RuleProblemsText::tr("It undoes what “%1” does at the same occasion. Give one of "
                                    "them a condition.")
            .arg(other);
    case RuleFlawKind::NoSeats:
        return RuleProblemsText::tr(
            "The scene has no seats to sit on: bring a stage with seats along.");
    case RuleFlawKind::NoExit:
        return RuleProblemsText::tr(
            "There is no exit to leave at, so characters stay: paint one with "
            "the environment brush (I).");
    }
    return {};
}

/// What is wrong beside what is still to be chosen.
QString otherFlaw(const Scene& scene, const Rule& rule)
{
    const std::vector<RuleFlaw> flaws = flawsOf(scene);
    const auto found = std::ranges::find(flaws, rule.id, &RuleFlaw::rule);
    return found == flaws.end() ? QString() : flawText(scene, *found);
}

} // namespace

QString ruleProblem(const Scene& scene, const Rule& rule)
{
    const Trigger& trigger = rule.trigger;
    if (const std::optional<RuleGap> gap = gapOf(rule)) {
        return gapText(*gap);
    }
    const bool isPlace = trigger.kind == TriggerKind::Arrived ||
                         trigger.kind == TriggerKind::Entered || trigger.kind == TriggerKind::Left;
    if (isPlace && trigger.place != 0 && scene.findPlace(trigger.place) == nullptr) {
        return RuleProblemsText::tr("The place is not there any more: choose another one.");
    }
    const bool isOfPath =
        trigger.kind == TriggerKind::PathEnded || trigger.kind == TriggerKind::AheadFree;
    if (isOfPath && trigger.path != 0 && scene.findPath(trigger.path) == nullptr) {
        return RuleProblemsText::tr("The path is not there any more: choose another one.");
    }
    for (const Condition& condition : rule.conditions) {
        const bool isOfPlace = condition.kind == ConditionKind::InPlace ||
                               condition.kind == ConditionKind::IsFull ||
                               condition.kind == ConditionKind::PeopleIn;
        const bool isGone =
            (isOfPlace && scene.findPlace(condition.place) == nullptr) ||
            (condition.kind == ConditionKind::Number && !hasNumber(scene, condition.number)) ||
            (condition.kind == ConditionKind::FollowsPath && condition.path != 0 &&
             scene.findPath(condition.path) == nullptr) ||
            (condition.kind == ConditionKind::Property &&
             condition.property == ComparedProperty::Clip && condition.clip.empty()) ||
            (condition.kind == ConditionKind::OfTemplate &&
             scene.findTemplate(condition.templateId) == nullptr);
        if (isGone) {
            return RuleProblemsText::tr(
                "A condition asks for something that is not there: choose again.");
        }
    }
    for (std::size_t line = 0; line < rule.actions.size(); ++line) {
        const QString block = blockProblem(rule.actions, line);
        const QString problem = block.isEmpty() ? actionProblem(scene, rule.actions[line]) : block;
        if (!problem.isEmpty()) {
            return problem;
        }
    }
    return otherFlaw(scene, rule);
}

QString problemText(const Scene& scene, const behavior::Problem& problem)
{
    const auto rule = std::ranges::find(scene.rules, problem.rule, &Rule::id);
    const QString text = rule == scene.rules.end() ? QString() : ruleProblem(scene, *rule);
    return text.isEmpty()
               ? QString::fromStdString(problem.text)
               : RuleProblemsText::tr("“%1”: %2").arg(QString::fromStdString(rule->name), text);
}

} // namespace crowd::widgets
