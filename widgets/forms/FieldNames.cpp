// SPDX-License-Identifier: MIT
#include "widgets/forms/FieldNames.h"

#include <algorithm>
#include <span>

#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLineEdit>

#include "model/brush/BrushSettings.h"
#include "model/scene/Scene.h"
#include "widgets/forms/ClipMix.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/FeatureTexts.h"
#include "widgets/state/RelationTexts.h"

namespace crowd::widgets {

using Bound = FieldForm::Bound;

namespace {

constexpr auto kByMouse = "isTakenByMouse"; ///< property of a list of suggestions

const model::Scene& sceneBehind(const FieldForm& form)
{
    static const model::Scene kNone;
    const model::Scene* scene = form.context().scene;
    return scene != nullptr ? *scene : kNone;
}

void addFeatureKind(FieldForm& form, const Bound& bound)
{
    QStringList texts;
    std::vector<std::string> names;
    for (const model::FeatureKind& kind : sceneBehind(form).features) {
        names.push_back(kind.name);
        texts << featureText(kind.name);
    }
    addName(form, bound, texts, names);
}

void addRelationName(FieldForm& form, const Bound& bound)
{
    QStringList texts;
    std::vector<std::string> names;
    for (const model::RelationKind& kind : sceneBehind(form).relationKinds) {
        names.push_back(kind.name);
        texts << relationText(kind.name);
    }
    addName(form, bound, texts, names);
}

/// None comes first.
void addCamera(FieldForm& form, const Bound& bound)
{
    QStringList texts{fieldText(bound.field->meta.zero)};
    std::vector<std::string> names{std::string()};
    for (const model::NamedCamera& camera : sceneBehind(form).cameras) {
        names.push_back(camera.name);
        texts << QString::fromStdString(camera.name);
    }
    addName(form, bound, texts, names);
}

/// Which kind of feature the same brush is set to.
std::string chosenKind(const FieldForm& form, const Bound& bound)
{
    const model::BrushSettings* brush = form.context().brush;
    const auto fields = brush != nullptr ? model::brushType(brush->kind()).fields
                                         : std::span<const model::FieldInfo>();
    const auto found = std::ranges::find_if(fields, [](const model::FieldInfo& field) {
        return field.meta.role == model::FieldRole::FeatureKind;
    });
    return found != fields.end() ? std::get<std::string>(found->get(form.object(bound)))
                                 : std::string();
}

/// Values of each kind, of which those of the chosen one are seen.
void addFeatures(FieldForm& form, const Bound& bound)
{
    for (const model::FeatureKind& kind : sceneBehind(form).features) {
        std::vector<std::string> names;
        for (const model::FeatureValue& value : kind.values) {
            names.push_back(value.name);
        }
        Bound ofKind = bound;
        ofKind.isShown = [&form, bound, name = kind.name] {
            return (!bound.isShown || bound.isShown()) && chosenKind(form, bound) == name;
        };
        addMix(form, ofKind, new ClipMix(names, &form, &featureText));
    }
}

bool isAmongTemplates(model::FieldRole role)
{
    return role == model::FieldRole::Clip || role == model::FieldRole::Slot ||
           role == model::FieldRole::Material || role == model::FieldRole::Part;
}

/// Names of what a role is about, of all templates, each once.
std::vector<std::string> namesFor(const model::Scene& scene, model::FieldRole role)
{
    std::vector<std::string> names;
    const auto add = [&names](const std::string& name) {
        if (std::ranges::find(names, name) == names.end()) {
            names.push_back(name);
        }
    };
    for (const model::TemplateEntry& entry : scene.templates) {
        if (role == model::FieldRole::Clip) {
            std::ranges::for_each(entry.clipNames, add);
        }
        if (!entry.asset) {
            continue;
        }
        for (const model::Slot& slot : entry.asset->slots) {
            if (role == model::FieldRole::Slot) {
                add(slot.name);
            } else if (role == model::FieldRole::Material) {
                std::ranges::for_each(slot.choices, add, &model::MaterialChoice::name);
            }
        }
        if (role == model::FieldRole::Part) {
            std::ranges::for_each(entry.asset->parts, add, &model::Part::name);
        }
    }
    return names;
}

/// A text that may be one of those of the scene's templates, for what names by words.
void addSuggestions(FieldForm& form, const Bound& bound)
{
    auto* box = new QComboBox(&form);
    box->setEditable(true);
    box->setInsertPolicy(QComboBox::NoInsert);
    box->setCompleter(nullptr); // a word is not to become the first name that begins with it
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    for (const std::string& name : namesFor(sceneBehind(form), bound.field->meta.role)) {
        box->addItem(QString::fromStdString(name));
    }
    box->setToolTip(fieldText(bound.field->meta.tip));
    const auto write = [&form, box, bound] {
        const std::string text = box->currentText().simplified().toStdString();
        if (text != form.valueOf<std::string>(bound)) {
            form.setValue(bound, text);
        }
    };
    // Who takes one by mouse does not mean to type: the next key is a brush's again.
    QObject::connect(box->view(), &QAbstractItemView::pressed, box,
                     [box] { box->setProperty(kByMouse, true); });
    QObject::connect(box, &QComboBox::activated, &form, [box, write] {
        write();
        if (box->property(kByMouse).toBool()) {
            box->setProperty(kByMouse, false);
            box->clearFocus();
        }
    });
    QObject::connect(box->lineEdit(), &QLineEdit::editingFinished, &form, write);
    form.addLabelled(
        fieldText(bound.field->meta.label), box,
        [&form, box, bound] {
            if (!box->lineEdit()->hasFocus()) {
                box->setEditText(QString::fromStdString(form.valueOf<std::string>(bound)));
            }
        },
        bound.isShown);
}

} // namespace

void addName(FieldForm& form, const Bound& bound, const QStringList& texts,
             const std::vector<std::string>& names)
{
    form.addChoice(
        fieldText(bound.field->meta.label), texts,
        [&form, bound, names] {
            const auto found = std::ranges::find(names, form.valueOf<std::string>(bound));
            return found == names.end() ? -1 : static_cast<int>(found - names.begin());
        },
        [&form, bound, names](int i) { form.setValue(bound, names[static_cast<std::size_t>(i)]); },
        bound.isShown);
}

void addMix(FieldForm& form, const Bound& bound, ClipMix* mix)
{
    using Clips = std::vector<model::ClipWeight>;
    QObject::connect(mix, &ClipMix::edited, &form, [&form, bound](const model::ClipWeight& edited) {
        auto all = form.valueOf<Clips>(bound);
        const auto known = std::ranges::find(all, edited.clip, &model::ClipWeight::clip);
        if (edited.weight <= 0.0F) {
            std::erase_if(all, [&](const auto& clip) { return clip.clip == edited.clip; });
        } else if (known != all.end()) {
            known->weight = edited.weight;
        } else {
            all.push_back(edited);
        }
        form.setValue(bound, std::move(all));
    });
    const bool isOfFeatures = bound.field->meta.role == model::FieldRole::Feature;
    form.bind(
        mix,
        [&form, mix, bound, isOfFeatures] {
            const model::BrushSettings* brush = form.context().brush;
            const bool areWeighed = !isOfFeatures || brush == nullptr ||
                                    model::operatorInfo(brush->op).usesDistribution;
            mix->setClips(form.valueOf<Clips>(bound), areWeighed);
        },
        bound.isShown);
}

bool addNamedControl(FieldForm& form, const Bound& bound)
{
    const model::FieldInfo& field = *bound.field;
    if (field.meta.role == model::FieldRole::Feature &&
        field.is<std::vector<model::ClipWeight>>()) {
        addFeatures(form, bound);
    } else if (field.meta.role == model::FieldRole::RelationKind) {
        addRelationName(form, bound);
    } else if (field.meta.role == model::FieldRole::Camera) {
        addCamera(form, bound);
    } else if (field.meta.role == model::FieldRole::FeatureKind) {
        addFeatureKind(form, bound);
    } else if (form.context().brush == nullptr && field.is<std::string>() &&
               isAmongTemplates(field.meta.role)) {
        addSuggestions(form, bound);
    } else {
        return false;
    }
    return true;
}

} // namespace crowd::widgets
