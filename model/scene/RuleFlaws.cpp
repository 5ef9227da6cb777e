// SPDX-License-Identifier: MIT
#include "model/scene/RuleFlaws.h"

#include <algorithm>
#include <limits>

#include "model/scene/RuleSequence.h"

namespace crowd::model {

namespace {

bool isOpen(std::uint32_t id)
{
    return id == 0 || id == kNotChosen;
}

std::optional<RuleGap> gapOf(const Trigger& trigger)
{
    const bool isOfPath =
        trigger.kind == TriggerKind::PathEnded || trigger.kind == TriggerKind::AheadFree;
    const bool isOfPlace = trigger.kind == TriggerKind::Arrived ||
                           trigger.kind == TriggerKind::Entered ||
                           trigger.kind == TriggerKind::Left;
    if (trigger.kind == TriggerKind::Event && trigger.event.empty()) {
        return RuleGap::Event;
    }
    if (isOfPlace && trigger.place == kNotChosen) {
        return RuleGap::Place;
    }
    return isOfPath && trigger.path == kNotChosen ? std::optional(RuleGap::Path) : std::nullopt;
}

std::optional<RuleGap> gapOf(const Condition& condition)
{
    switch (condition.kind) {
    case ConditionKind::OfTemplate:
        return condition.templateId == 0 ? std::optional(RuleGap::Template) : std::nullopt;
    case ConditionKind::InPlace:
    case ConditionKind::IsFull:
    case ConditionKind::PeopleIn:
        return isOpen(condition.place) ? std::optional(RuleGap::Place) : std::nullopt;
    case ConditionKind::Number:
        return condition.number == 0 ? std::optional(RuleGap::Number) : std::nullopt;
    case ConditionKind::Property:
        return condition.property == ComparedProperty::Clip && condition.clip.empty()
                   ? std::optional(RuleGap::Clip)
                   : std::nullopt;
    default:
        return std::nullopt;
    }
}

std::optional<RuleGap> placeGapOf(const Action& action)
{
    const bool isGiven = action.choice == PlaceChoice::Given;
    switch (action.kind) {
    case ActionKind::GoToPlace:
        return (isGiven && isOpen(action.place)) || action.place == kNotChosen
                   ? std::optional(RuleGap::Place)
               : !isGiven && action.path == kNotChosen ? std::optional(RuleGap::Path)
                                                       : std::nullopt;
    case ActionKind::LeaveScene:
        return action.place == kNotChosen || action.path == kNotChosen
                   ? std::optional(RuleGap::Place)
                   : std::nullopt;
    case ActionKind::Appear:
        return isOpen(action.place) ? std::optional(RuleGap::Place) : std::nullopt;
    case ActionKind::Flee:
    case ActionKind::TurnTo:
    case ActionKind::LookAt:
        return action.aim == ActionAim::Place && isOpen(action.place)
                   ? std::optional(RuleGap::Place)
                   : std::nullopt;
    default:
        return std::nullopt;
    }
}

std::optional<RuleGap> gapOf(const Action& action)
{
    switch (action.kind) {
    case ActionKind::PlayClip:
        return action.clips.empty() ? std::optional(RuleGap::Clip) : std::nullopt;
    case ActionKind::SetProperty:
        return action.property == SettableProperty::Clip && action.clips.empty()
                   ? std::optional(RuleGap::Clip)
                   : std::nullopt;
    case ActionKind::FollowPath:
        return isOpen(action.path) ? std::optional(RuleGap::Path) : std::nullopt;
    case ActionKind::SendEvent:
        return action.event.empty() ? std::optional(RuleGap::SentEvent) : std::nullopt;
    case ActionKind::WaitForEvent:
        return action.event.empty() ? std::optional(RuleGap::AwaitedEvent) : std::nullopt;
    case ActionKind::SetNumber:
    case ActionKind::AddToNumber:
        return action.number == 0 ? std::optional(RuleGap::Number) : std::nullopt;
    default:
        return placeGapOf(action);
    }
}

/// Whether two conditions ask for the same thing, one way or the other.
bool isSameQuestion(const Condition& a, const Condition& b)
{
    if (a.kind != b.kind) {
        return false;
    }
    switch (a.kind) {
    case ConditionKind::HasTag:
        return a.tag == b.tag;
    case ConditionKind::OfTemplate:
        return a.templateId == b.templateId;
    case ConditionKind::InPlace:
    case ConditionKind::IsFull:
    case ConditionKind::PeopleIn:
        return a.place == b.place;
    case ConditionKind::FollowsPath:
        return a.path == b.path;
    case ConditionKind::Number:
        return a.number == b.number;
    case ConditionKind::Property:
        return a.property == b.property &&
               (a.property != ComparedProperty::Clip || a.clip == b.clip);
    case ConditionKind::Chance:
        return false; // each is a draw of its own
    case ConditionKind::IsSeated:
    case ConditionKind::Speed:
    case ConditionKind::Payload:
        return true;
    }
    return false;
}

bool isCompared(const Condition& condition)
{
    switch (condition.kind) {
    case ConditionKind::Number:
    case ConditionKind::Speed:
    case ConditionKind::Payload:
    case ConditionKind::PeopleIn:
        return true;
    case ConditionKind::Property:
        return condition.property != ComparedProperty::Clip;
    default:
        return false;
    }
}

/// Numbers for which a comparison holds; ends that are not part of it are left out by `isOpen`.
struct Range
{
    float low = -std::numeric_limits<float>::infinity();
    float high = std::numeric_limits<float>::infinity();
    bool isLowOut = false;
    bool isHighOut = false;
};

/// Nothing: all but one number.
std::optional<Range> rangeOf(const Condition& condition)
{
    Range range;
    const float value = condition.value;
    switch (condition.comparison) {
    case Comparison::Equal:
        range.low = value;
        range.high = value;
        return condition.isNot ? std::nullopt : std::optional(range);
    case Comparison::Less:
        (condition.isNot ? range.low : range.high) = value;
        range.isHighOut = !condition.isNot;
        return range;
    case Comparison::More:
        (condition.isNot ? range.high : range.low) = value;
        range.isLowOut = !condition.isNot;
        return range;
    }
    return std::nullopt;
}

bool areApart(const Range& a, const Range& b)
{
    const auto isBelow = [](const Range& low, const Range& high) {
        return low.high < high.low || (low.high == high.low && (low.isHighOut || high.isLowOut));
    };
    return isBelow(a, b) || isBelow(b, a);
}

/// Both at once cannot be.
bool excludes(const Condition& a, const Condition& b)
{
    if (isSameQuestion(a, b)) {
        if (!isCompared(a)) {
            return a.isNot != b.isNot;
        }
        const std::optional<Range> left = rangeOf(a);
        const std::optional<Range> right = rangeOf(b);
        return left && right && areApart(*left, *right);
    }
    if (a.kind != b.kind || a.isNot || b.isNot) {
        return false;
    }
    const bool areClips = a.kind == ConditionKind::Property &&
                          a.property == ComparedProperty::Clip && b.property == a.property;
    return a.kind == ConditionKind::OfTemplate || areClips ||
           (a.kind == ConditionKind::FollowsPath && a.path != 0 && b.path != 0);
}

/// What can be for nobody at any time.
bool isImpossible(const Condition& condition)
{
    if (condition.kind == ConditionKind::Chance) {
        return condition.isNot ? condition.chance >= 1.0F : condition.chance <= 0.0F;
    }
    const bool isNeverBelowZero = isCompared(condition) &&
                                  condition.kind != ConditionKind::Number &&
                                  condition.kind != ConditionKind::Payload;
    const std::optional<Range> range = isCompared(condition) ? rangeOf(condition) : std::nullopt;
    return isNeverBelowZero && range &&
           areApart(*range, {0.0F, std::numeric_limits<float>::infinity()});
}

bool isNeverTrue(const Rule& rule)
{
    const std::vector<Condition>& all = rule.conditions;
    if (rule.isAnyEnough) {
        return !all.empty() && std::ranges::all_of(all, isImpossible);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (excludes(all[i], all[j])) {
                return true;
            }
        }
    }
    return std::ranges::any_of(all, isImpossible);
}

bool excludes(const Rule& a, const Rule& b)
{
    return !a.isAnyEnough && !b.isAnyEnough &&
           std::ranges::any_of(a.conditions, [&](const Condition& left) {
               return std::ranges::any_of(
                   b.conditions, [&](const Condition& right) { return excludes(left, right); });
           });
}

/// Whether two triggers always come together.
bool isSameOccasion(const Trigger& a, const Trigger& b)
{
    if (a.kind != b.kind) {
        return false;
    }
    switch (a.kind) {
    case TriggerKind::Event:
        return a.event == b.event;
    case TriggerKind::Arrived:
    case TriggerKind::Entered:
    case TriggerKind::Left:
        return a.place == b.place;
    case TriggerKind::PathEnded:
    case TriggerKind::AheadFree:
        return a.path == b.path;
    case TriggerKind::Waited:
        return a.seconds == b.seconds;
    case TriggerKind::TagNear:
        return a.tag == b.tag && a.metres == b.metres;
    case TriggerKind::SpeedLimit:
        return a.isAbove == b.isAbove && a.metresPerSecond == b.metresPerSecond;
    case TriggerKind::Every:
        return false; // each has a clock of its own
    case TriggerKind::Start:
    case TriggerKind::ClipEnded:
        return true;
    }
    return false;
}

/// Whether one comes wherever the other does.
bool comesWherever(const Rule& rule, const Rule& other)
{
    const bool hasChance = std::ranges::find(rule.conditions, ConditionKind::Chance,
                                             &Condition::kind) != rule.conditions.end();
    const bool isAsWide =
        rule.conditions.empty() || (rule.conditions == other.conditions && !hasChance &&
                                    rule.isAnyEnough == other.isAnyEnough);
    return isAsWide && rule.limit == 0 && rule.cooldownSeconds <= 0.0F &&
           rule.meeting == RuleMeeting::Interrupt;
}

bool areOpposite(const Action& a, const Action& b)
{
    const auto isPair = [&](ActionKind one, ActionKind other) {
        return (a.kind == one && b.kind == other) || (a.kind == other && b.kind == one);
    };
    return (isPair(ActionKind::AddTag, ActionKind::RemoveTag) && a.tag == b.tag) ||
           isPair(ActionKind::Stop, ActionKind::GoOn) ||
           isPair(ActionKind::SitDown, ActionKind::StandUp);
}

bool undoes(const Rule& a, const Rule& b)
{
    return std::ranges::any_of(a.actions, [&](const Action& one) {
        return one.depth == 0 && std::ranges::any_of(b.actions, [&](const Action& other) {
                   return other.depth == 0 && areOpposite(one, other);
               });
    });
}

/// What a rule does to one below it or that one to it.
void addFlawsOfPair(const Rule& upper, const Rule& lower, std::vector<RuleFlaw>& flaws)
{
    if (!isSameOccasion(upper.trigger, lower.trigger) || excludes(upper, lower)) {
        return;
    }
    const bool givesWay = upper.yields == RuleYield::Anybody;
    if (!givesWay && lower.meeting != RuleMeeting::Queue && comesWherever(upper, lower)) {
        flaws.push_back({lower.id, RuleFlawKind::Hidden, {}, upper.id});
    } else if (givesWay && lower.meeting == RuleMeeting::Interrupt && comesWherever(lower, upper)) {
        flaws.push_back({upper.id, RuleFlawKind::BrokenOff, {}, lower.id});
    } else if (undoes(upper, lower)) {
        flaws.push_back({lower.id, RuleFlawKind::Undone, {}, upper.id});
    }
}

void addOwnFlaws(const Scene& scene, const Rule& rule, bool hasSeats, std::vector<RuleFlaw>& flaws)
{
    if (isNeverTrue(rule)) {
        flaws.push_back({rule.id, RuleFlawKind::NeverTrue});
    }
    const bool sits =
        std::ranges::find(rule.actions, ActionKind::SitDown, &Action::kind) != rule.actions.end();
    if (sits && !hasSeats) {
        flaws.push_back({rule.id, RuleFlawKind::NoSeats});
    }
    const bool needsExit = std::ranges::any_of(rule.actions, [](const Action& action) {
        return action.kind == ActionKind::LeaveScene && action.choice != PlaceChoice::Given &&
               action.place == 0 && action.path == 0;
    });
    if (needsExit &&
        std::ranges::find(scene.places, PlaceRole::Exit, &Place::role) == scene.places.end()) {
        flaws.push_back({rule.id, RuleFlawKind::NoExit});
    }
}

std::string gapText(RuleGap gap)
{
    switch (gap) {
    case RuleGap::Event:
        return "type the event that it waits for";
    case RuleGap::SentEvent:
        return "type the event to send";
    case RuleGap::AwaitedEvent:
        return "type the event to wait for";
    case RuleGap::Clip:
        return "choose a clip";
    case RuleGap::Place:
        return "choose a place";
    case RuleGap::Path:
        return "choose a path";
    case RuleGap::Number:
        return "choose a number";
    case RuleGap::Template:
        return "choose a template";
    case RuleGap::Deed:
        return "add something to do";
    }
    return {};
}

std::string ruleNamed(const Scene& scene, RuleId id)
{
    const auto found = std::ranges::find(scene.rules, id, &Rule::id);
    return "rule \"" + (found == scene.rules.end() ? std::string() : found->name) + "\"";
}

} // namespace

std::optional<RuleGap> gapOf(const Rule& rule)
{
    std::optional<RuleGap> gap = gapOf(rule.trigger);
    for (std::size_t i = 0; !gap && i < rule.conditions.size(); ++i) {
        gap = gapOf(rule.conditions[i]);
    }
    if (!gap && rule.actions.empty()) {
        return RuleGap::Deed;
    }
    for (std::size_t i = 0; !gap && i < rule.actions.size(); ++i) {
        gap = gapOf(rule.actions[i]);
    }
    return gap;
}

std::vector<RuleFlaw> flawsOf(const Scene& scene)
{
    std::vector<RuleFlaw> flaws;
    const bool hasSeats = std::ranges::any_of(scene.stages, [](const StageEntry& stage) {
        return !stage.asset || !stage.asset->seats.empty(); // one that is not there may have some
    });
    std::vector<const Rule*> acting;
    for (const Rule& rule : scene.rules) {
        if (!rule.isEnabled) {
            continue;
        }
        if (const std::optional<RuleGap> gap = gapOf(rule)) {
            flaws.push_back({rule.id, RuleFlawKind::Unfinished, *gap});
            continue;
        }
        addOwnFlaws(scene, rule, hasSeats, flaws);
        for (const Rule* upper : acting) {
            addFlawsOfPair(*upper, rule, flaws);
        }
        acting.push_back(&rule);
    }
    return flaws;
}

std::string englishOf(const RuleFlaw& flaw, const Scene& scene)
{
    std::string text = ruleNamed(scene, flaw.rule);
    text.front() = 'R';
    const std::string other = ruleNamed(scene, flaw.other);
    switch (flaw.kind) {
    case RuleFlawKind::Unfinished:
        return text + " does nothing yet: " + gapText(flaw.gap) + ".";
    case RuleFlawKind::NeverTrue:
        return text + " never comes: its conditions exclude each other. Remove one of them.";
    case RuleFlawKind::Hidden:
        return text + " never comes: " + other +
               " above it comes at the same occasion. Let this one wait until they are free, or "
               "give one of them a condition.";
    case RuleFlawKind::BrokenOff:
        return text + " gets nothing done: " + other +
               " breaks it off at once. Let one of them wait until they are free, or give it a "
               "condition.";
    case RuleFlawKind::Undone:
        return text + " undoes what " + other +
               " does at the same occasion. Give one of them a condition.";
    case RuleFlawKind::NoSeats:
        return text +
               " lets characters sit down, but the scene has no seats. Bring a stage with seats "
               "along.";
    case RuleFlawKind::NoExit:
        return text +
               " lets characters leave at an exit, but there is none: they stay. Paint one with "
               "the environment brush.";
    }
    return text;
}

} // namespace crowd::model
