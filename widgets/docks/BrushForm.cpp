// SPDX-License-Identifier: MIT
#include "widgets/docks/BrushForm.h"

#include <algorithm>
#include <string_view>

#include "model/brush/FeatureBrush.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

using model::BrushKind;
using model::BrushSettings;

namespace {

FormTarget targetOf(EditorState& state, const BrushTarget& target)
{
    return {[read = target.read] { return static_cast<const void*>(&read()); },
            [target](const std::function<void(void*)>& apply) {
                BrushSettings brush = target.read();
                apply(&brush);
                target.write(brush);
            },
            [&state, read = target.read] {
                return model::FieldContext{&state.scene(), &read()};
            }};
}

/// One of the fields that all brushes have.
const model::FieldInfo& commonField(std::string_view key)
{
    return *std::ranges::find_if(model::fieldsOf<BrushSettings>(),
                                 [key](const auto& field) { return key == field.meta.key; });
}

/// Those of area and reach: all but the operator's.
std::span<const model::FieldInfo> areaFields()
{
    static const std::vector<model::FieldInfo> kFields = [] {
        std::vector<model::FieldInfo> fields;
        for (const model::FieldInfo& field : model::fieldsOf<BrushSettings>()) {
            const std::string_view key = field.meta.key;
            if (key != "operator" && key != "distribution" && key != "mask") {
                fields.push_back(field);
            }
        }
        return fields;
    }();
    return kFields;
}

void addOperator(FieldForm& form, const BrushTarget& brush)
{
    const auto opOf = [read = brush.read]() -> const model::OperatorInfo& {
        return model::operatorInfo(read().op);
    };
    form.beginSection(fieldText(QT_TRANSLATE_NOOP("Fields", "Operator")),
                      QStringLiteral("operator"));
    form.addField(commonField("operator"), {}, {});
    form.addField(commonField("distribution"), {}, [opOf] { return opOf().usesDistribution; });
    form.addNote(fieldText(model::brushType(brush.read().kind()).info.gradientNote),
                 [opOf] { return opOf().followsLine; });
    form.addNote(FieldForm::tr("All get the value that was ticked first."), [read = brush.read] {
        const model::FeatureSettings* features = model::featureSettings(read());
        return features != nullptr && !features->takesOff && features->values.size() > 1 &&
               read().op == model::BrushOperator::Uniform;
    });
}

/// Creation always draws; who draws a distribution wants it used.
void addCreationCurve(FieldForm& form)
{
    static const model::FieldInfo kCurve = [] {
        model::FieldInfo field = commonField("distribution");
        field.set = [](void* object, const model::FieldValue& value) {
            auto& brush = *static_cast<BrushSettings*>(object);
            brush.distribution = std::get<model::DistributionCurve>(value);
            brush.op = model::BrushOperator::Random;
        };
        return field;
    }();
    form.addField(kCurve, {}, {});
}

/// The curve stands with what varies, before the ways that people face.
void addOwnFields(FieldForm& form, const model::BrushType& type)
{
    const FieldPath path = [&type](void* brush) {
        return type.editable(*static_cast<BrushSettings*>(brush));
    };
    const auto facing = std::ranges::find_if(type.fields, [&](const model::FieldInfo& field) {
        return type.info.family == model::StrokeFamily::Creation &&
               std::string_view(field.meta.key) == "facing";
    });
    const auto early = static_cast<std::size_t>(facing - type.fields.begin());
    form.addFields(type.fields.first(early), path);
    if (early < type.fields.size()) {
        addCreationCurve(form);
        form.addFields(type.fields.subspan(early), path);
    }
}

void addNotes(FieldForm& form, const model::BrushInfo& info, const BrushTarget& brush)
{
    const auto hasCorners = [read = brush.read] {
        const auto* places = read().find<model::EnvironmentSettings>();
        return places != nullptr && places->shape != model::PlaceShape::Round;
    };
    const bool isEither = *info.cornersNote != '\0';
    if (*info.note != '\0') {
        form.addNote(fieldText(info.note), [=] { return !isEither || !hasCorners(); });
    }
    if (isEither) {
        form.addNote(fieldText(info.cornersNote), hasCorners);
    }
}

void addScriptFields(FieldForm& form, const EditorState& state)
{
    const auto& brushes = state.scriptBrushes();
    const std::string& name = state.brush(BrushKind::Script).as<model::ScriptSettings>().brush;
    const auto chosen = std::ranges::find_if(brushes, [&](const ScriptBrush& each) {
        return each.settings.as<model::ScriptSettings>().brush == name;
    });
    if (chosen == brushes.end()) {
        form.addNote(FieldForm::tr("Scripts bring brushes along: a Python class with "
                                   "apply(selection), made known with "
                                   "crowdbrush.register_brush(MyBrush), has its place in the "
                                   "palette and its settings here."));
        return;
    }
    form.beginSection(QString::fromStdString(name), QStringLiteral("script"));
    if (!chosen->tip.isEmpty()) {
        form.addNote(chosen->tip);
    }
    form.addFields(*chosen->fields, [kept = chosen->fields](void* brush) -> void* {
        return &static_cast<BrushSettings*>(brush)->as<model::ScriptSettings>();
    });
}

} // namespace

namespace {

FieldForm* brushForm(EditorState& state, const BrushTarget& brush, EditorState* picking,
                     QWidget* parent)
{
    const BrushKind kind = brush.read().kind();
    const model::BrushType& type = model::brushType(kind);
    auto* form = new FieldForm(targetOf(state, brush),
                               QStringLiteral("brushForm/%1").arg(QLatin1String(type.info.id)),
                               picking, parent);
    if (type.info.family != model::StrokeFamily::Places) {
        form->addFields(areaFields());
    }
    if (type.info.operatorPlace == model::OperatorPlace::First) {
        addOperator(*form, brush);
    }
    addOwnFields(*form, type);
    if (type.info.operatorPlace == model::OperatorPlace::Last) {
        addOperator(*form, brush);
    }
    if (type.info.operatorPlace == model::OperatorPlace::CurveOnly) {
        form->addField(commonField("distribution"), {}, {});
    }
    if (kind == BrushKind::Script) {
        addScriptFields(*form, state);
    }
    addNotes(*form, type.info, brush); // else they stand under a mask that has no fields
    form->addField(commonField("mask"), {}, {});
    form->finish();
    return form;
}

} // namespace

FieldForm* makeBrushForm(EditorState& state, BrushKind kind, QWidget* parent)
{
    const BrushTarget brush{[&state, kind]() -> const BrushSettings& { return state.brush(kind); },
                            [&state](const BrushSettings& settings) { state.setBrush(settings); }};
    return brushForm(state, brush, &state, parent);
}

FieldForm* makeBrushForm(EditorState& state, const BrushTarget& brush, QWidget* parent)
{
    return brushForm(state, brush, nullptr, parent);
}

} // namespace crowd::widgets
