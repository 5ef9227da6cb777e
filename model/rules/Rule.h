// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/rules/Actions.h"
#include "model/rules/Conditions.h"
#include "model/rules/RuleKind.h"
#include "model/rules/RuleNames.h"
#include "model/rules/Triggers.h"

/// Rules as data: "when this happens, and these conditions hold, do this sequence". What they mean
/// is behavior's affair. Metres, seconds. The parts are made of what they hold:
/// rule.actions = {actions::Stop(), actions::SetSpeed{2.0F}}. They are copied, moved and described
/// in Rule.cpp alone: a variant of many kinds takes long to compile wherever it is.
namespace crowd::model {

extern template std::span<const RuleKind> kindsOf<TriggerData>();
extern template std::span<const RuleKind> kindsOf<ConditionData>();
extern template std::span<const RuleKind> kindsOf<ActionData>();

struct Trigger : RulePart<TriggerData>
{
    Trigger() : RulePart(triggers::Event()) {}
    Trigger(const Trigger& other);
    Trigger(Trigger&& other) noexcept;
    Trigger& operator=(const Trigger& other);
    Trigger& operator=(Trigger&& other) noexcept;
    ~Trigger();
    template<KindOf<TriggerData> Kind>
    Trigger(Kind kind) : RulePart(std::move(kind)) // NOLINT(google-explicit-constructor)
    {
    }
    friend bool operator==(const Trigger&, const Trigger&) = default;
};

struct Condition : RulePart<ConditionData>
{
    bool isNot = false;

    Condition() = default;
    Condition(const Condition& other);
    Condition(Condition&& other) noexcept;
    Condition& operator=(const Condition& other);
    Condition& operator=(Condition&& other) noexcept;
    ~Condition();
    template<KindOf<ConditionData> Kind>
    Condition(Kind kind, bool isNegated = false) // NOLINT(google-explicit-constructor)
        : RulePart(std::move(kind)), isNot(isNegated)
    {
    }
    friend bool operator==(const Condition&, const Condition&) = default;
};

struct Action : RulePart<ActionData>
{
    std::uint8_t depth = 0; ///< deeper ones belong to a Repeat or OneOf above; see RuleSequence.h

    Action() = default;
    Action(const Action& other);
    Action(Action&& other) noexcept;
    Action& operator=(const Action& other);
    Action& operator=(Action&& other) noexcept;
    ~Action();
    template<KindOf<ActionData> Kind>
    Action(Kind kind, std::uint8_t howDeep = 0) // NOLINT(google-explicit-constructor)
        : RulePart(std::move(kind)), depth(howDeep)
    {
    }
    friend bool operator==(const Action&, const Action&) = default;
};

/// What happens to somebody who is busy with another rule.
enum class RuleMeeting : std::uint8_t { Interrupt, Queue, Ignore };

/// Which rules may break off what a rule lets somebody do.
enum class RuleYield : std::uint8_t {
    FurtherUp, ///< rules above it in the list, and itself
    Anybody,
    Nobody,
    Others ///< rules above it in the list, but not itself
};

struct Rule
{
    RuleId id = 0;
    std::string name;
    bool isEnabled = true;
    Trigger trigger;
    std::vector<Condition> conditions;
    bool isAnyEnough = false; ///< one of the conditions, else all
    std::vector<Action> actions;
    RuleMeeting meeting = RuleMeeting::Interrupt;
    RuleYield yields = RuleYield::FurtherUp;
    float cooldownSeconds = 0.0F; ///< for the same individual
    std::uint32_t limit = 0;      ///< so often for the same individual; 0: as often as it comes
    std::string unknownMembers;   ///< see Scene::unknownMembers
    friend bool operator==(const Rule&, const Rule&) = default;
};

/// Calls act(kind, object) for the trigger, each condition and each action.
template<class Act>
void forEachPart(const Rule& rule, const Act& act)
{
    act(rule.trigger.kind(), rule.trigger.object());
    for (const Condition& condition : rule.conditions) {
        act(condition.kind(), condition.object());
    }
    for (const Action& action : rule.actions) {
        act(action.kind(), action.object());
    }
}

/// Ids of the places, the paths and so on that a rule names, as often as it does; 0 and kNotChosen
/// are among them.
[[nodiscard]] std::vector<std::uint32_t> idsNamedIn(const Rule& rule, FieldRole role);

} // namespace crowd::model
