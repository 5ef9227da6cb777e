// SPDX-License-Identifier: MIT
#include "widgets/rules/RuleProblems.h"

#include <algorithm>

#include <QtCore/QCoreApplication>

#include "model/base/Translated.h"
#include "model/rules/RuleFlaws.h"
#include "model/rules/RuleSequence.h"

namespace crowd::widgets {

using namespace model;

namespace {

struct RuleProblemsText
{
    Q_DECLARE_TR_FUNCTIONS(Rules)
};

QString blockProblem(const Actions& actions, std::size_t line)
{
    if (actions[line].is<actions::Repeat>() && endOf(actions, line) == line + 1) {
        return RuleProblemsText::tr("There is nothing to repeat: press “+ in it”.");
    }
    if (!actions[line].is<actions::OneOf>()) {
        return {};
    }
    const std::vector<std::size_t> lines = alternativesOf(actions, line);
    const bool isAny = std::ranges::any_of(
        lines, [&](std::size_t each) { return actions[each].as<actions::OneOf>()->weight > 0.0F; });
    if (lines.size() < 2) {
        return RuleProblemsText::tr("There is only one to choose: press “+ or…” for another.");
    }
    return isAny ? QString()
                 : RuleProblemsText::tr("None of them ever comes: let one come more often.");
}

/// An id that names one of the entries, or nothing.
template<class Entry>
bool isThere(const std::vector<Entry>& entries, std::int64_t id)
{
    return id == 0 || std::ranges::find(entries, id, &Entry::id) != entries.end();
}

bool hasSlot(const Scene& scene, const std::string& name)
{
    return std::ranges::any_of(scene.templates, [&](const TemplateEntry& entry) {
        return !entry.asset || entry.asset->slotIndex(name) >= 0; // who is not there may have it
    });
}

bool hasAnyOf(const Scene& scene, const std::vector<ClipWeight>& clips)
{
    return std::ranges::any_of(clips, [&](const ClipWeight& clip) {
        return std::ranges::any_of(scene.templates, [&](const TemplateEntry& entry) {
            return std::ranges::find(entry.clipNames, clip.clip) != entry.clipNames.end();
        });
    });
}

/// Of a field that names something of the scene which is not there.
QString missingText(const Scene& scene, const FieldMeta& meta, const FieldValue& value)
{
    const auto* id = std::get_if<std::int64_t>(&value);
    const auto* text = std::get_if<std::string>(&value);
    const auto* clips = std::get_if<std::vector<ClipWeight>>(&value);
    if (meta.role == FieldRole::Place && !isThere(scene.places, *id)) {
        return RuleProblemsText::tr("The place is not there any more: choose another one.");
    }
    if (meta.role == FieldRole::Path && !isThere(scene.paths, *id)) {
        return RuleProblemsText::tr("The path is not there any more: choose another one.");
    }
    if (meta.role == FieldRole::ArtistNumber && !isThere(scene.numbers, *id)) {
        return RuleProblemsText::tr(
            "The number is not there: make one below, under “Tags and numbers”.");
    }
    if (meta.role == FieldRole::State && !isThere(scene.states, *id)) {
        return RuleProblemsText::tr("The state is not there any more: choose another one.");
    }
    if (meta.role == FieldRole::Light && !isThere(scene.lights, *id)) {
        return RuleProblemsText::tr("The light is not there any more: choose another one.");
    }
    if (meta.role == FieldRole::Feature && !isThere(model::allFeatures(scene.features), *id)) {
        return RuleProblemsText::tr("The feature is not there any more: choose another one.");
    }
    if (meta.role == FieldRole::Relation && !isThere(scene.relationKinds, *id)) {
        return RuleProblemsText::tr("The relation is not there any more: choose another one.");
    }
    if (meta.role == FieldRole::Template && !isThere(scene.templates, *id)) {
        return RuleProblemsText::tr(
            "A condition asks for something that is not there: choose again.");
    }
    if (meta.role == FieldRole::Slot && !text->empty() && !hasSlot(scene, *text)) {
        return RuleProblemsText::tr("Nobody has a slot of that name: choose one.");
    }
    return clips != nullptr && !hasAnyOf(scene, *clips)
               ? RuleProblemsText::tr("Nobody has a clip to play: choose one.")
               : QString();
}

/// What a part of a rule names and the scene has not.
template<class Data>
QString missingText(const Scene& scene, const RulePart<Data>& part)
{
    for (const FieldInfo& field : part.kind().fields) {
        QString text = isShown(field, part.object())
                           ? missingText(scene, field.meta, field.get(part.object()))
                           : QString();
        if (!text.isEmpty()) {
            return text;
        }
    }
    return {};
}

QString actionProblem(const Scene& scene, const Action& action)
{
    const auto isToPlace = [](const auto* each) {
        return each != nullptr && each->aim == ActionAim::Place;
    };
    if (isToPlace(action.as<actions::GoToPerson>()) || isToPlace(action.as<actions::Follow>())) {
        return RuleProblemsText::tr("A place is nobody to go after: choose whom.");
    }
    return missingText(scene, action);
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
    case RuleGap::State:
        return RuleProblemsText::tr("It does nothing yet: choose a state; the panel States keeps "
                                    "one.");
    case RuleGap::Light:
        return RuleProblemsText::tr(
            "It does nothing yet: choose a light; the panel Light adds one.");
    case RuleGap::Feature:
        return RuleProblemsText::tr("It does nothing yet: choose a feature.");
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
    case RuleFlawKind::NoSender:
        return RuleProblemsText::tr(
            "It is about whoever it came from, but it comes from nobody: let it begin with an "
            "event or with someone near, or choose whom it is about.");
    case RuleFlawKind::NoPayload:
        return RuleProblemsText::tr(
            "It asks for an event’s number, but comes without one: let it begin with an event, or "
            "give the number.");
    case RuleFlawKind::AfterAgain:
        return RuleProblemsText::tr(
            "What stands below “do it again” is never done: move it up, or remove it.");
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
    if (const std::optional<RuleGap> gap = gapOf(rule)) {
        return gapText(*gap);
    }
    if (QString missing = missingText(scene, rule.trigger); !missing.isEmpty()) {
        return missing;
    }
    for (const Condition& condition : rule.conditions) {
        if (!missingText(scene, condition).isEmpty()) {
            return RuleProblemsText::tr(
                "A condition asks for something that is not there: choose again.");
        }
    }
    for (std::size_t line = 0; line < rule.actions.size(); ++line) {
        const QString block = blockProblem(rule.actions, line);
        QString problem = block.isEmpty() ? actionProblem(scene, rule.actions[line]) : block;
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
               ? model::translated(problem.text)
               : RuleProblemsText::tr("“%1”: %2").arg(QString::fromStdString(rule->name), text);
}

} // namespace crowd::widgets
