// SPDX-License-Identifier: MIT
#include "app/record/FieldScript.h"

#include <string_view>

#include "app/record/ScriptText.h"
#include "model/brush/BrushSettings.h"
#include "model/describe/FieldChecks.h"

namespace crowd::app {

using namespace model;

namespace {

std::string textOf(const ValueRange& range)
{
    return '(' + pythonText(range.low) + ", " + pythonText(range.high) + ')';
}

std::string textOf(const std::vector<int>& numbers)
{
    std::vector<std::string> items;
    items.reserve(numbers.size());
    for (const int each : numbers) {
        items.push_back(pythonText(each));
    }
    return pythonList(items, 0);
}

std::string textOf(const PaintColor& color)
{
    return '(' + pythonText(color[0]) + ", " + pythonText(color[1]) + ", " + pythonText(color[2]) +
           ')';
}

std::string textOf(const Tint& tint)
{
    return '(' + pythonText(tint.red) + ", " + pythonText(tint.green) + ", " +
           pythonText(tint.blue) + ", " + pythonText(tint.strength) + ')';
}

std::string textOf(const std::vector<PaintColor>& colors)
{
    std::vector<std::string> items;
    items.reserve(colors.size());
    for (const PaintColor& each : colors) {
        items.push_back(textOf(each));
    }
    return pythonList(items, 0);
}

std::string textOf(const std::vector<ClipWeight>& clips)
{
    std::vector<std::string> items;
    items.reserve(clips.size());
    for (const ClipWeight& each : clips) {
        items.push_back(pythonText(each.clip) + ": " + pythonText(each.weight));
    }
    return pythonList(items, 0, '{', '}');
}

std::string textOf(const std::vector<TemplateWeight>& mix)
{
    std::vector<std::string> items;
    items.reserve(mix.size());
    for (const TemplateWeight& each : mix) {
        items.push_back(pythonText(each.id) + ": " + pythonText(each.weight));
    }
    return pythonList(items, 0, '{', '}');
}

std::string textOf(const DistributionCurve& curve)
{
    std::vector<std::string> items;
    for (const float each : curve.weights) {
        items.push_back(pythonText(each));
    }
    return pythonList(items, 0);
}

std::string textOf(const std::optional<bool>& value)
{
    return value ? pythonText(*value) : "None";
}

std::string textOf(const FieldInfo& field, std::int64_t value)
{
    const auto choices = field.meta.choices;
    if (choices.empty()) {
        return pythonText(value);
    }
    const char* key = choices[static_cast<std::size_t>(value)].key;
    const char* type = choices.data() == kSelections        ? "Selection"
                       : choices.data() == kOperatorChoices ? "Operator"
                       : choices.data() == kHeadingModes    ? "Facing"
                       : choices.data() == kTimeModes       ? "Timing"
                       : choices.data() == kPushModes       ? "Movement"
                                                            : nullptr;
    return type != nullptr ? std::string("crowdbrush.") + type + '.' + key
                           : pythonText(std::string_view(key));
}

template<class T>
std::string textOf(const FieldInfo& /*field*/, const T& value)
{
    // A number would become a flag on its way to std::optional<bool>.
    if constexpr (!std::is_arithmetic_v<T> && requires { textOf(value); }) {
        return textOf(value);
    } else {
        return pythonText(value);
    }
}

} // namespace

std::vector<std::pair<std::string, std::string>> fieldArguments(std::span<const FieldInfo> fields,
                                                                const void* was, const void* now)
{
    std::vector<std::pair<std::string, std::string>> arguments;
    for (const FieldInfo& field : fields) {
        const FieldValue value = field.get(now);
        if (field.meta.isStored && value != field.get(was)) {
            arguments.emplace_back(
                attributeOf(field.meta.key),
                std::visit([&](const auto& held) { return textOf(field, held); }, value));
        }
    }
    return arguments;
}

std::string fieldChanges(std::span<const FieldInfo> fields, const void* was, const void* now,
                         const std::string& name)
{
    std::string text;
    for (const FieldInfo& field : fields) {
        if (!field.meta.isStored) {
            continue;
        }
        const std::string attribute = name + '.' + attributeOf(field.meta.key);
        if (field.isGroup()) {
            // What is inside is only read.
            text += fieldChanges(field.children, field.childOf(const_cast<void*>(was)),
                                 field.childOf(const_cast<void*>(now)), attribute);
            continue;
        }
        const FieldValue value = field.get(now);
        if (value != field.get(was)) {
            text += attribute + " = " +
                    std::visit([&](const auto& held) { return textOf(field, held); }, value) + '\n';
        }
    }
    return text;
}

} // namespace crowd::app
