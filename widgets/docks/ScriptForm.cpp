// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <variant>

#include "widgets/docks/BrushForm.h"

namespace crowd::widgets {

namespace {

using model::BrushSettings;
using model::PaintColor;

/// The value in the settings of that moment; nothing after another brush took its place.
template<class T, class Settings>
auto valueIn(Settings& settings, const std::string& name)
{
    const auto found = std::ranges::find(settings.script.values, name, &model::ScriptValue::name);
    return found == settings.script.values.end() ? nullptr : std::get_if<T>(&found->value);
}

template<class T>
auto getter(const std::string& name)
{
    return [name](const BrushSettings& settings) {
        const T* value = valueIn<T>(settings, name);
        return value != nullptr ? *value : T();
    };
}

template<class T>
auto setter(const std::string& name)
{
    return [name](BrushSettings& settings, const T& value) {
        if (T* kept = valueIn<T>(settings, name)) {
            *kept = value;
        }
    };
}

void addChoices(BrushForm& form, const ScriptField& field)
{
    const QStringList choices = field.choices;
    form.addChoice(
        field.label, choices,
        [get = getter<std::string>(field.name), choices](const BrushSettings& s) {
            return static_cast<int>(choices.indexOf(QString::fromStdString(get(s))));
        },
        [set = setter<std::string>(field.name), choices](BrushSettings& s, int i) {
            set(s, choices[i].toStdString());
        });
}

void addField(BrushForm& form, const ScriptField& field, const model::ScriptValue& value)
{
    const std::string& name = field.name;
    const ValueSlider::Range range{field.low, field.high, field.step, field.decimals, {}, false};
    if (std::holds_alternative<bool>(value.value)) {
        form.addCheck(field.label, {}, getter<bool>(name), setter<bool>(name));
    } else if (std::holds_alternative<std::int64_t>(value.value)) {
        form.addSlider(
            field.label, range,
            [get = getter<std::int64_t>(name)](const BrushSettings& s) {
                return static_cast<double>(get(s));
            },
            [set = setter<std::int64_t>(name)](BrushSettings& s, double number) {
                set(s, static_cast<std::int64_t>(std::llround(number)));
            });
    } else if (std::holds_alternative<double>(value.value)) {
        form.addSlider(field.label, range, getter<double>(name), setter<double>(name));
    } else if (std::holds_alternative<PaintColor>(value.value)) {
        form.addColour(field.label, getter<PaintColor>(name), setter<PaintColor>(name));
    } else if (!field.choices.isEmpty()) {
        addChoices(form, field);
    } else {
        form.addText(
            field.label,
            [get = getter<std::string>(name)](const BrushSettings& s) {
                return QString::fromStdString(get(s));
            },
            [set = setter<std::string>(name)](BrushSettings& s, const QString& text) {
                set(s, text.toStdString());
            });
    }
}

} // namespace

void addScriptSettings(BrushForm& form, EditorState& state)
{
    const auto& brushes = state.scriptBrushes();
    const std::string& name = state.brush(model::BrushKind::Script).script.brush;
    const auto chosen = std::ranges::find_if(
        brushes, [&](const ScriptBrush& each) { return each.settings.script.brush == name; });
    if (chosen == brushes.end()) {
        form.addNote(BrushForm::tr("Scripts bring brushes along: a Python class with "
                                   "apply(selection), made known with "
                                   "crowdbrush.register_brush(MyBrush), has its place in the "
                                   "palette and its settings here."));
        return;
    }
    form.beginSection(QString::fromStdString(name), QStringLiteral("script"));
    if (!chosen->tip.isEmpty()) {
        form.addNote(chosen->tip);
    }
    const auto& values = chosen->settings.script.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        addField(form, chosen->fields[i], values[i]);
    }
}

} // namespace crowd::widgets
