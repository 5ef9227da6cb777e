// SPDX-License-Identifier: MIT
#include "model/rules/Rule.h"

namespace crowd::model {

template std::span<const RuleKind> kindsOf<TriggerData>();
template std::span<const RuleKind> kindsOf<ConditionData>();
template std::span<const RuleKind> kindsOf<ActionData>();

Trigger::Trigger(const Trigger& other) = default;
Trigger::Trigger(Trigger&& other) noexcept = default;
Trigger& Trigger::operator=(const Trigger& other) = default;
Trigger& Trigger::operator=(Trigger&& other) noexcept = default;
Trigger::~Trigger() = default;

Condition::Condition(const Condition& other) = default;
Condition::Condition(Condition&& other) noexcept = default;
Condition& Condition::operator=(const Condition& other) = default;
Condition& Condition::operator=(Condition&& other) noexcept = default;
Condition::~Condition() = default;

Action::Action(const Action& other) = default;
Action::Action(Action&& other) noexcept = default;
Action& Action::operator=(const Action& other) = default;
Action& Action::operator=(Action&& other) noexcept = default;
Action::~Action() = default;

std::vector<std::uint32_t> idsNamedIn(const Rule& rule, FieldRole role)
{
    std::vector<std::uint32_t> ids;
    forEachPart(rule, [&](const RuleKind& kind, const void* object) {
        for (const FieldInfo& field : kind.fields) {
            if (field.meta.role == role && field.meta.isStored) {
                const FieldValue value = field.get(object);
                ids.push_back(static_cast<std::uint32_t>(std::get<std::int64_t>(value)));
            }
        }
    });
    return ids;
}

} // namespace crowd::model
