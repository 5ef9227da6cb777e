// SPDX-License-Identifier: MIT
#include "model/rules/RuleFlaws.h"

#include <algorithm>
#include <limits>

#include "model/rules/RuleSequence.h"

namespace crowd::model {

namespace {

/// What a field that is shown still lacks. Who reads it says what an event that has no name is for.
std::optional<RuleGap> gapOf(const FieldInfo& field, const void* object)
{
    const FieldValue value = field.get(object);
    const bool mayBeNone = *field.meta.zero != 0;
    if (const auto* id = std::get_if<std::int64_t>(&value)) {
        const bool isOpen = *id == std::int64_t{kNotChosen} || (*id == 0 && !mayBeNone);
        switch (field.meta.role) {
        case FieldRole::Place:
            return isOpen ? std::optional(RuleGap::Place) : std::nullopt;
        case FieldRole::Path:
            return isOpen ? std::optional(RuleGap::Path) : std::nullopt;
        case FieldRole::ArtistNumber:
            return isOpen ? std::optional(RuleGap::Number) : std::nullopt;
        case FieldRole::State:
            return isOpen ? std::optional(RuleGap::State) : std::nullopt;
        case FieldRole::Light:
            return isOpen ? std::optional(RuleGap::Light) : std::nullopt;
        case FieldRole::Feature:
            return isOpen ? std::optional(RuleGap::Feature) : std::nullopt;
        case FieldRole::Template:
            return isOpen ? std::optional(RuleGap::Template) : std::nullopt;
        default:
            return std::nullopt;
        }
    }
    if (const auto* text = std::get_if<std::string>(&value)) {
        return !text->empty() || mayBeNone           ? std::nullopt
               : field.meta.role == FieldRole::Event ? std::optional(RuleGap::Event)
               : field.meta.role == FieldRole::Clip  ? std::optional(RuleGap::Clip)
                                                     : std::nullopt;
    }
    const auto* clips = std::get_if<std::vector<ClipWeight>>(&value);
    return clips != nullptr && clips->empty() ? std::optional(RuleGap::Clip) : std::nullopt;
}

template<class Data>
std::optional<RuleGap> gapOf(const RulePart<Data>& part)
{
    for (const FieldInfo& field : part.kind().fields) {
        if (isShown(field, part.object())) {
            if (const std::optional<RuleGap> gap = gapOf(field, part.object())) {
                return gap;
            }
        }
    }
    return std::nullopt;
}

std::optional<RuleGap> gapOf(const Action& action)
{
    const std::optional<RuleGap> gap = gapOf<ActionData>(action);
    return gap != RuleGap::Event                ? gap
           : action.is<actions::WaitForEvent>() ? RuleGap::AwaitedEvent
                                                : RuleGap::SentEvent;
}

/// What a condition compares with a value; both null: nothing.
struct Compared
{
    const Comparison* comparison = nullptr;
    const float* value = nullptr;
};

Compared comparedBy(const Condition& condition)
{
    return std::visit(
        [](const auto& each) -> Compared {
            if constexpr (requires { each.isClip(); }) {
                return each.isClip() ? Compared() : Compared{&each.comparison, &each.value};
            } else if constexpr (requires { each.comparison; }) {
                return {&each.comparison, &each.value};
            } else {
                return {};
            }
        },
        condition.data);
}

/// Whether two conditions ask for the same thing, one way or the other.
bool isSameQuestion(const Condition& a, const Condition& b)
{
    if (a.data.index() != b.data.index() || a.is<conditions::Chance>()) {
        return false; // each chance is a draw of its own
    }
    return std::ranges::all_of(a.kind().fields, [&](const FieldInfo& field) {
        const std::string_view key(field.meta.key);
        const bool isAsked = key != "compare" && key != "value" && isShown(field, a.object());
        return !isAsked || field.get(a.object()) == field.get(b.object());
    });
}

bool isCompared(const Condition& condition)
{
    return comparedBy(condition).comparison != nullptr;
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
    const Compared compared = comparedBy(condition);
    const float value = *compared.value;
    switch (*compared.comparison) {
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
    if (a.data.index() != b.data.index() || a.isNot || b.isNot) {
        return false;
    }
    if (const auto* path = a.as<conditions::FollowsPath>()) {
        return path->path != 0 && b.as<conditions::FollowsPath>()->path != 0;
    }
    if (const auto* property = a.as<conditions::Property>()) {
        return property->isClip() && b.as<conditions::Property>()->isClip();
    }
    return a.is<conditions::OfTemplate>();
}

/// What can be for nobody at any time.
bool isImpossible(const Condition& condition)
{
    if (const auto* chance = condition.as<conditions::Chance>()) {
        return condition.isNot ? chance->chance >= 1.0F : chance->chance <= 0.0F;
    }
    const bool isNeverBelowZero = isCompared(condition) && !condition.is<conditions::Number>() &&
                                  !condition.is<conditions::Payload>();
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
    return a.data == b.data && !a.is<triggers::Every>(); // of which each has a clock of its own
}

/// Whether one comes wherever the other does.
bool comesWherever(const Rule& rule, const Rule& other)
{
    const bool hasChance = std::ranges::any_of(
        rule.conditions, [](const Condition& each) { return each.is<conditions::Chance>(); });
    const bool isAsWide =
        rule.conditions.empty() || (rule.conditions == other.conditions && !hasChance &&
                                    rule.isAnyEnough == other.isAnyEnough);
    return isAsWide && rule.limit == 0 && rule.cooldownSeconds <= 0.0F &&
           rule.meeting == RuleMeeting::Interrupt;
}

template<class One, class Other>
bool isPair(const Action& a, const Action& b)
{
    return (a.is<One>() && b.is<Other>()) || (a.is<Other>() && b.is<One>());
}

bool areOpposite(const Action& a, const Action& b)
{
    using namespace actions;
    if (isPair<AddTag, RemoveTag>(a, b)) {
        const auto tagOf = [](const Action& each) {
            return each.is<AddTag>() ? each.as<AddTag>()->tag : each.as<RemoveTag>()->tag;
        };
        return tagOf(a) == tagOf(b);
    }
    return isPair<Stop, GoOn>(a, b) || isPair<SitDown, StandUp>(a, b);
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

bool isOfSomebody(const Trigger& trigger)
{
    return trigger.is<triggers::Event>() || trigger.is<triggers::TagNear>() ||
           trigger.is<triggers::RelatedDid>();
}

bool hasPayload(const Trigger& trigger)
{
    const auto* related = trigger.as<triggers::RelatedDid>();
    return trigger.is<triggers::Event>() ||
           (related != nullptr && related->deed == RelatedDeed::Hears);
}

bool isAboutSender(const Action& action)
{
    return std::visit(
        [](const auto& each) {
            if constexpr (requires { each.kNeedsSender; }) {
                return false; // it goes without
            } else if constexpr (requires { each.aim == ActionAim::Sender; }) {
                return each.aim == ActionAim::Sender;
            } else {
                return false;
            }
        },
        action.data);
}

bool takesPayload(const Action& action)
{
    return std::visit(
        [](const auto& each) {
            if constexpr (requires { each.takesPayload(); }) {
                return each.takesPayload();
            } else {
                return false;
            }
        },
        action.data);
}

/// What is about an event or somebody that the rule does not come from.
std::optional<RuleFlawKind> unfoundedPart(const Rule& rule)
{
    bool isKnown = isOfSomebody(rule.trigger);
    bool isCounted = hasPayload(rule.trigger);
    const auto asksFor = [](const Condition& each) { return each.is<conditions::Payload>(); };
    if (!isCounted && std::ranges::any_of(rule.conditions, asksFor)) {
        return RuleFlawKind::NoPayload;
    }
    for (const Action& action : rule.actions) {
        if (action.is<actions::WaitForEvent>()) { // from here on there is one
            isKnown = true;
            isCounted = true;
        } else if (!isKnown && isAboutSender(action)) {
            return RuleFlawKind::NoSender;
        } else if (!isCounted && takesPayload(action)) {
            return RuleFlawKind::NoPayload;
        }
    }
    return std::nullopt;
}

bool hasLinesAfterAgain(const Actions& actions)
{
    for (std::size_t i = 0; i + 1 < actions.size(); ++i) {
        if (actions[i].is<actions::Again>() && actions[i + 1].depth == actions[i].depth) {
            return true;
        }
    }
    return false;
}

void addOwnFlaws(const Scene& scene, const Rule& rule, bool hasSeats, std::vector<RuleFlaw>& flaws)
{
    if (const std::optional<RuleFlawKind> unfounded = unfoundedPart(rule)) {
        flaws.push_back({rule.id, *unfounded});
    }
    if (hasLinesAfterAgain(rule.actions)) {
        flaws.push_back({rule.id, RuleFlawKind::AfterAgain});
    }
    if (isNeverTrue(rule)) {
        flaws.push_back({rule.id, RuleFlawKind::NeverTrue});
    }
    const bool sits = std::ranges::any_of(
        rule.actions, [](const Action& action) { return action.is<actions::SitDown>(); });
    if (sits && !hasSeats) {
        flaws.push_back({rule.id, RuleFlawKind::NoSeats});
    }
    const bool needsExit = std::ranges::any_of(rule.actions, [](const Action& action) {
        const auto* leave = action.as<actions::LeaveScene>();
        return leave != nullptr && leave->choice != PlaceChoice::Given && leave->place == 0 &&
               leave->path == 0;
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
    case RuleGap::State:
        return "choose a state";
    case RuleGap::Light:
        return "choose a light";
    case RuleGap::Feature:
        return "choose a feature";
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
    case RuleFlawKind::NoSender:
        return text +
               " is about whoever it came from, but it comes from nobody. Let it begin with an "
               "event or with somebody near, or choose whom it is about.";
    case RuleFlawKind::NoPayload:
        return text +
               " asks for the number of an event, but it comes without one. Let it begin with an "
               "event, or give the number.";
    case RuleFlawKind::AfterAgain:
        return text + " begins anew at \"do it again\": what stands below that is never done. Move "
                      "it up, or remove it.";
    }
    return text;
}

} // namespace crowd::model
