// SPDX-License-Identifier: MIT
#include "widgets/state/ScriptBrush.h"

#include <algorithm>
#include <deque>

namespace crowd::widgets {

namespace {

using model::FieldInfo;
using model::FieldValue;
using model::ScriptSettings;

/// Descriptions with the texts that they point to.
struct OwnedFields
{
    std::vector<ScriptField> texts;
    std::deque<std::vector<model::FieldChoice>> choices;
    std::vector<FieldInfo> fields;
};

template<class T, class Settings>
auto valueIn(Settings& settings, const std::string& name)
{
    const auto found = std::ranges::find(settings.values, name, &model::ScriptValue::name);
    return found == settings.values.end() ? nullptr : std::get_if<T>(&found->value);
}

/// Reads and writes the value in the settings of that moment; nothing after another brush took its
/// place.
template<class T>
void access(FieldInfo& field, const std::string& name)
{
    field.type = FieldValue(T()).index();
    field.get = [name](const void* object) {
        const T* value = valueIn<T>(*static_cast<const ScriptSettings*>(object), name);
        return FieldValue(value != nullptr ? *value : T());
    };
    field.set = [name](void* object, const FieldValue& value) {
        if (T* kept = valueIn<T>(*static_cast<ScriptSettings*>(object), name)) {
            *kept = std::get<T>(value);
        }
    };
}

FieldInfo describe(const ScriptField& said, const std::vector<model::FieldChoice>& choices,
                   const model::ScriptValue& value)
{
    FieldInfo field;
    field.meta.key = said.name.c_str();
    field.meta.label = said.label.c_str();
    field.meta.low = said.low;
    field.meta.high = said.high;
    field.meta.step = said.step;
    field.meta.decimals = said.decimals;
    field.meta.choices = choices;
    std::visit([&](const auto& held) { access<std::decay_t<decltype(held)>>(field, said.name); },
               value.value);
    return field;
}

} // namespace

FieldList describeScriptFields(std::vector<ScriptField> fields,
                               const std::vector<model::ScriptValue>& values)
{
    auto owned = std::make_shared<OwnedFields>();
    owned->texts = std::move(fields);
    for (std::size_t i = 0; i < owned->texts.size() && i < values.size(); ++i) {
        auto& choices = owned->choices.emplace_back();
        for (const std::string& choice : owned->texts[i].choices) {
            choices.push_back({choice.c_str(), choice.c_str()});
        }
        owned->fields.push_back(describe(owned->texts[i], choices, values[i]));
    }
    return {owned, &owned->fields};
}

} // namespace crowd::widgets
