// SPDX-License-Identifier: MIT
#include "widgets/rules/RulePartRows.h"

#include <cmath>

#include <QtCore/QCoreApplication>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QVBoxLayout>

#include "widgets/rules/RuleFields.h"
#include "widgets/rules/RuleNames.h"

namespace crowd::widgets {

using model::FieldInfo;
using model::FieldMeta;
using model::FieldRole;
using model::FieldValue;

namespace {

struct RulePartText
{
    Q_DECLARE_TR_FUNCTIONS(Rules)
};

/// Of the control, as shown.
double lowestShown(const FieldMeta& meta)
{
    const bool isOwn = meta.sliderLow != 0.0 || meta.sliderHigh != 0.0;
    return isOwn ? meta.sliderLow : meta.low * meta.shownScale;
}

double highestShown(const FieldMeta& meta)
{
    const bool isOwn = meta.sliderLow != 0.0 || meta.sliderHigh != 0.0;
    return isOwn ? meta.sliderHigh : meta.high * meta.shownScale;
}

/// Choices that are offered, and the one that is chosen.
void addChoices(QHBoxLayout* row, const FieldMeta& meta, std::int64_t value,
                const std::function<void(std::int64_t)>& changed)
{
    QStringList names;
    std::vector<std::int64_t> values;
    int chosen = -1;
    for (std::size_t i = 0; i < meta.choices.size(); ++i) {
        const auto each = static_cast<std::int64_t>(i);
        if (meta.choices[i].isOffered || each == value) {
            chosen = each == value ? static_cast<int>(names.size()) : chosen;
            names << ruleText(meta.choices[i].label);
            values.push_back(each);
        }
    }
    addChoiceField(row, names, chosen, [values, changed](int index) {
        changed(values[static_cast<std::size_t>(index)]);
    });
}

} // namespace

QHBoxLayout* PartRows::add(std::span<const FieldInfo> fields, const void* object) const
{
    QHBoxLayout* row = nullptr; // that fields may stand beside each other in
    QHBoxLayout* last = nullptr;
    const FieldInfo* clips = nullptr;
    for (const FieldInfo& field : fields) {
        if (!field.meta.isBeside) {
            row = nullptr;
        }
        if (!model::isShown(field, object)) {
            continue;
        }
        row = row == nullptr ? newRow() : row;
        last = row;
        addField(row, field, object);
        clips = field.is<std::vector<model::ClipWeight>>() ? &field : clips;
    }
    if (clips != nullptr) {
        addClipWeights(layout, std::get<std::vector<model::ClipWeight>>(clips->get(object)),
                       [change = changed, clips](const auto& all) { change(*clips, all); });
    }
    return last;
}

void PartRows::addField(QHBoxLayout* row, const FieldInfo& field, const void* object) const
{
    const QString tip = ruleText(field.meta.tip);
    if (*field.meta.label != 0) {
        auto* label = new QLabel(ruleText(field.meta.label));
        label->setToolTip(tip);
        row->addWidget(label);
    }
    addControl(row, field, field.get(object));
    QWidget* control = row->itemAt(row->count() - 1)->widget();
    if (control->toolTip().isEmpty()) {
        control->setToolTip(tip);
    }
}

void PartRows::addControl(QHBoxLayout* row, const FieldInfo& field, const FieldValue& value) const
{
    const FieldMeta& meta = field.meta;
    const auto set = [change = changed, &field](const FieldValue& edited) {
        change(field, edited);
    };
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        addInteger(row, field, *whole);
    } else if (const auto* real = std::get_if<float>(&value)) {
        addNumberField(
            row, static_cast<double>(*real) * meta.shownScale, lowestShown(meta),
            highestShown(meta), ruleText(meta.unit),
            [set, scale = meta.shownScale](double shown) {
                set(static_cast<float>(shown / scale));
            },
            ruleText(meta.zero));
    } else if (const auto* isOn = std::get_if<bool>(&value)) {
        addChoices(row, meta, *isOn ? 1 : 0, [set](std::int64_t chosen) { set(chosen == 1); });
    } else if (const auto* text = std::get_if<std::string>(&value)) {
        addText(row, field, *text);
    } else if (const auto* color = std::get_if<model::PaintColor>(&value)) {
        addColorField(row, *color, ruleText(meta.tip),
                      [set](const model::PaintColor& edited) { set(edited); });
    } else if (const auto* clips = std::get_if<std::vector<model::ClipWeight>>(&value)) {
        addClipField(row, scene, *clips,
                     [set](const std::vector<model::ClipWeight>& edited) { set(edited); });
    }
}

void PartRows::addInteger(QHBoxLayout* row, const FieldInfo& field, std::int64_t value) const
{
    const FieldMeta& meta = field.meta;
    const auto set = [change = changed, &field](std::int64_t edited) { change(field, edited); };
    if (!meta.choices.empty()) {
        addChoices(row, meta, value, set);
        return;
    }
    switch (meta.role) {
    case FieldRole::Place:
    case FieldRole::Path:
    case FieldRole::Template:
    case FieldRole::ArtistNumber:
    case FieldRole::State:
    case FieldRole::Light:
    case FieldRole::Feature:
    case FieldRole::Relation:
        addReferenceField(row, scene, meta.role, static_cast<std::uint32_t>(value),
                          ruleText(meta.zero), set);
        return;
    case FieldRole::Tag:
        addTagField(row, scene, static_cast<std::uint8_t>(value), set);
        return;
    default:
        break;
    }
    if (meta.shownScale == 1.0) {
        addCountField(row, static_cast<std::uint32_t>(value),
                      static_cast<std::uint32_t>(highestShown(meta)), ruleText(meta.unit), set,
                      ruleText(meta.zero));
    } else {
        addNumberField(
            row, static_cast<double>(value) * meta.shownScale, lowestShown(meta),
            highestShown(meta), ruleText(meta.unit),
            [set, scale = meta.shownScale](double shown) { set(std::llround(shown / scale)); });
    }
}

void PartRows::addText(QHBoxLayout* row, const FieldInfo& field, const std::string& text) const
{
    const auto set = [change = changed, &field](const std::string& edited) {
        change(field, edited);
    };
    if (field.meta.role == FieldRole::Clip) {
        addOneClipField(row, scene, text, set);
    } else if (field.meta.role == FieldRole::Slot) {
        addSlotField(row, scene, text, set);
    } else {
        addTextField(row, QString::fromStdString(text), RulePartText::tr("event"),
                     [set](const QString& edited) { set(edited.toStdString()); });
    }
}

} // namespace crowd::widgets
