// SPDX-License-Identifier: MIT
#include "app/record/StrokeScript.h"

#include "app/record/ScriptText.h"

namespace crowd::app {

using namespace model;

namespace {

/// Of the script: "colour_brush".
std::string variableOf(BrushKind kind)
{
    return std::string(brushType(kind).info.id) + "_brush";
}

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
    const char* type = choices.data() == kSelections        ? "Selection"
                       : choices.data() == kOperatorChoices ? "Operator"
                                                            : "Facing";
    return std::string("crowdbrush.") + type + '.' + choices[static_cast<std::size_t>(value)].key;
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

/// Assignments of what differs between two objects.
std::string differences(std::span<const FieldInfo> fields, const void* was, const void* now,
                        const std::string& name)
{
    std::string text;
    for (const FieldInfo& field : fields) {
        const std::string attribute = name + '.' + field.meta.key;
        if (field.isGroup()) {
            // What is inside is only read.
            text += differences(field.children, field.childOf(const_cast<void*>(was)),
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

std::string points(const std::vector<PointerInput>& inputs)
{
    std::vector<std::string> rows;
    for (const PointerInput& each : inputs) {
        const glm::dvec2 at = each.pixels();
        rows.push_back('(' + pythonText(at.x) + ", " + pythonText(at.y) + ", " +
                       pythonText(each.pressure) + ", " + pythonText(each.timeSeconds) + ", " +
                       pythonText(each.shownSeconds) + ')');
    }
    return pythonList(rows, 0);
}

} // namespace

std::string StrokeScript::brush(const BrushSettings& settings)
{
    const BrushType& type = brushType(settings.kind());
    const std::string variable = variableOf(settings.kind());
    std::string text;
    const auto known = m_said.find(settings.kind());
    BrushSettings was(settings.kind());
    if (known == m_said.end()) {
        text =
            variable + " = crowdbrush.Brush(crowdbrush.BrushKind." + type.info.scriptKind + ")\n";
        // Said whatever it is: it is what brushes of scripts and of the window begin with
        // differently.
        if (auto* create = was.find<CreateSettings>()) {
            create->anywhere = !settings.as<CreateSettings>().anywhere;
        }
    } else {
        was = known->second;
    }
    const std::string section = type.info.scriptName;
    text += differences(fieldsOf<BrushSettings>(), &was, &settings, variable);
    text += differences(type.fields, type.settings(was), type.settings(settings),
                        section.empty() ? variable : variable + '.' + section);
    m_said[settings.kind()] = settings;
    return text;
}

std::string StrokeScript::write(const RecordedStroke& stroke)
{
    std::string text = brush(stroke.settings);
    if (m_camera != stroke.camera) {
        m_camera = stroke.camera;
        text += "view = " + pythonText(stroke.camera) + '\n';
    }
    return text + "scene.stroke(" + variableOf(stroke.settings.kind()) + ", " +
           points(stroke.inputs) + ", camera=view, size=(" + pythonText(stroke.viewSize.x) + ", " +
           pythonText(stroke.viewSize.y) + "), seed=" + pythonText(stroke.seed) + ")\n";
}

} // namespace crowd::app
