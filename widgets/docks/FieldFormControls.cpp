// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <QtWidgets/QCheckBox>
#include <QtWidgets/QColorDialog>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>

#include "widgets/docks/CurveEditor.h"
#include "widgets/docks/FieldForm.h"
#include "widgets/docks/NumberList.h"
#include "widgets/docks/RangeSlider.h"
#include "widgets/state/BrushTexts.h"

namespace crowd::widgets {

using model::FieldMeta;

namespace {

QString labelOf(const FieldForm::Bound& bound)
{
    return fieldText(bound.field->meta.label);
}

QString tipTextOf(const FieldForm::Bound& bound)
{
    return fieldText(bound.field->meta.tip);
}

/// Of the control: the slider's own range, else the legal one as it is shown.
ValueSlider::Range controlRange(const FieldMeta& meta)
{
    const bool isOwn = meta.sliderLow != 0.0 || meta.sliderHigh != 0.0;
    return {isOwn ? meta.sliderLow : meta.low * meta.shownScale,
            isOwn ? meta.sliderHigh : meta.high * meta.shownScale,
            meta.step,
            meta.decimals,
            fieldText(meta.unit),
            meta.isLogarithmic};
}

} // namespace

void FieldForm::addControl(const Bound& bound)
{
    using namespace model;
    const FieldInfo& field = *bound.field;
    if (addReferenceControl(*this, bound)) {
        return;
    }
    if (!field.meta.choices.empty()) {
        field.is<std::string>() ? addTextChoices(bound) : addChoices(bound);
    } else if (field.is<bool>() || field.is<std::optional<bool>>()) {
        addFlag(bound);
    } else if (field.is<float>() || field.is<double>() || field.is<std::int64_t>()) {
        const ValueSlider::Range range = controlRange(field.meta);
        addNumber(bound, range.low, range.high);
    } else if (field.is<ValueRange>()) {
        addRange(bound);
    } else if (field.is<std::string>()) {
        addText(bound);
    } else if (field.is<PaintColor>()) {
        addColour(bound);
    } else if (field.is<DistributionCurve>()) {
        addCurve(bound);
    } else if (field.is<std::vector<int>>()) {
        addNumberList(bound);
    }
}

void FieldForm::addLabelled(const QString& label, QWidget* control, std::function<void()> refresh,
                            Condition isShown)
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* text = new QLabel(label, row);
    text->setBuddy(control);
    layout->addWidget(text);
    layout->addWidget(control, 1);
    bind(row, std::move(refresh), std::move(isShown));
}

void FieldForm::addSlider(const QString& label, const ValueSlider::Range& range,
                          std::function<double()> get, std::function<void(double)> set,
                          Condition isShown)
{
    auto* slider = new ValueSlider(label, range, this);
    connect(slider, &ValueSlider::valueEdited, this, std::move(set));
    bind(
        slider, [slider, get = std::move(get)] { slider->setValue(get()); }, std::move(isShown));
}

void FieldForm::addNumber(const Bound& bound, double low, double high)
{
    ValueSlider::Range range = controlRange(bound.field->meta);
    range.low = low;
    range.high = high;
    const double scale = bound.field->meta.shownScale;
    const auto get = [this, bound, scale] {
        return std::visit(
            [scale](const auto& number) {
                if constexpr (std::is_arithmetic_v<std::decay_t<decltype(number)>>) {
                    return static_cast<double>(number) * scale;
                } else {
                    return 0.0;
                }
            },
            value(bound));
    };
    const auto set = [this, bound, scale](double shown) {
        if (bound.field->is<std::int64_t>()) {
            setValue(bound, static_cast<std::int64_t>(std::llround(shown / scale)));
        } else if (bound.field->is<double>()) {
            setValue(bound, shown / scale);
        } else {
            setValue(bound, static_cast<float>(shown / scale));
        }
    };
    addSlider(labelOf(bound), range, get, set, bound.isShown);
}

void FieldForm::addFlag(const Bound& bound)
{
    auto* box = new QCheckBox(labelOf(bound), this);
    box->setToolTip(tipTextOf(bound));
    const bool isOptional = bound.field->is<std::optional<bool>>();
    connect(box, &QCheckBox::clicked, this, [this, bound, isOptional](bool on) {
        setValue(bound,
                 isOptional ? model::FieldValue(std::optional<bool>(on)) : model::FieldValue(on));
    });
    bind(
        box,
        [this, box, bound, isOptional] {
            box->setChecked(isOptional ? valueOf<std::optional<bool>>(bound).value_or(true)
                                       : valueOf<bool>(bound));
        },
        bound.isShown);
}

void FieldForm::addChoice(const QString& label, const QStringList& names, std::function<int()> get,
                          std::function<void(int)> set, Condition isShown)
{
    auto* box = new QComboBox(this);
    box->addItems(names);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(box, &QComboBox::activated, this, std::move(set));
    addLabelled(
        label, box, [box, get = std::move(get)] { box->setCurrentIndex(get()); },
        std::move(isShown));
}

void FieldForm::addChoices(const Bound& bound)
{
    const auto choices = bound.field->meta.choices;
    const bool isFlag = bound.field->is<bool>();
    QStringList names;
    for (const model::FieldChoice& choice : choices) {
        names << fieldText(choice.label);
    }
    const auto chosen = [this, bound, isFlag] {
        return isFlag ? static_cast<int>(valueOf<bool>(bound))
                      : static_cast<int>(valueOf<std::int64_t>(bound));
    };
    addChoice(
        labelOf(bound), names, chosen,
        [this, bound, isFlag](int index) {
            setValue(bound, isFlag ? model::FieldValue(index == 1)
                                   : model::FieldValue(static_cast<std::int64_t>(index)));
        },
        bound.isShown);
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (*choices[i].tip != '\0') {
            addNote(fieldText(choices[i].tip), [bound, chosen, i] {
                return (!bound.isShown || bound.isShown()) && chosen() == static_cast<int>(i);
            });
        }
    }
}

void FieldForm::addTextChoices(const Bound& bound)
{
    QStringList names;
    QStringList keys;
    for (const model::FieldChoice& choice : bound.field->meta.choices) {
        names << fieldText(choice.label);
        keys << QString::fromUtf8(choice.key);
    }
    addChoice(
        labelOf(bound), names,
        [this, bound, keys] {
            return static_cast<int>(
                keys.indexOf(QString::fromStdString(valueOf<std::string>(bound))));
        },
        [this, bound, keys](int index) { setValue(bound, keys[index].toStdString()); },
        bound.isShown);
}

void FieldForm::addText(const Bound& bound)
{
    auto* line = new QLineEdit(this);
    line->setObjectName(QStringLiteral("brushText"));
    line->setToolTip(tipTextOf(bound));
    connect(line, &QLineEdit::textEdited, this,
            [this, bound](const QString& text) { setValue(bound, text.toStdString()); });
    addLabelled(
        labelOf(bound), line,
        [this, line, bound] {
            if (!line->hasFocus()) {
                line->setText(QString::fromStdString(valueOf<std::string>(bound)));
            }
        },
        bound.isShown);
}

void FieldForm::addRange(const Bound& bound)
{
    const ValueSlider::Range range = controlRange(bound.field->meta);
    const auto scale = static_cast<float>(bound.field->meta.shownScale);
    auto* slider = new RangeSlider(labelOf(bound), range, this);
    connect(slider, &RangeSlider::valueEdited, this,
            [this, bound, scale](const model::ValueRange& edited) {
                setValue(bound, model::ValueRange{edited.low / scale, edited.high / scale});
            });
    bind(
        slider,
        [this, slider, bound, scale] {
            const auto shown = valueOf<model::ValueRange>(bound);
            slider->setValue({shown.low * scale, shown.high * scale});
        },
        bound.isShown);
}

void FieldForm::addColour(const Bound& bound)
{
    auto* button = new QToolButton(this);
    const QString label = labelOf(bound);
    button->setAccessibleName(label);
    connect(button, &QToolButton::clicked, this, [this, label, bound] {
        const auto now = valueOf<model::PaintColor>(bound);
        const QColor chosen = QColorDialog::getColor(QColor(now[0], now[1], now[2]), this, label,
                                                     QColorDialog::DontUseNativeDialog);
        if (chosen.isValid()) {
            setValue(bound, model::PaintColor{static_cast<std::uint8_t>(chosen.red()),
                                              static_cast<std::uint8_t>(chosen.green()),
                                              static_cast<std::uint8_t>(chosen.blue())});
        }
    });
    addLabelled(
        label, button,
        [this, button, bound] {
            const auto now = valueOf<model::PaintColor>(bound);
            QPixmap swatch(32, 14);
            swatch.fill(QColor(now[0], now[1], now[2]));
            button->setIconSize(swatch.size());
            button->setIcon(swatch);
        },
        bound.isShown);
}

void FieldForm::addCurve(const Bound& bound)
{
    auto* curve = new CurveEditor(this);
    curve->setToolTip(tipTextOf(bound));
    connect(curve, &CurveEditor::edited, this,
            [this, curve, bound] { setValue(bound, curve->curve()); });
    addLabelled(
        labelOf(bound), curve,
        [this, curve, bound] { curve->setCurve(valueOf<model::DistributionCurve>(bound)); },
        bound.isShown);
}

void FieldForm::addNumberList(const Bound& bound)
{
    auto* line = new QLineEdit(this);
    line->setMinimumWidth(40);
    line->setPlaceholderText(tr("all"));
    line->setToolTip(tipTextOf(bound));
    connect(line, &QLineEdit::editingFinished, this,
            [this, line, bound] { setValue(bound, numberListOf(line->text())); });
    addLabelled(
        labelOf(bound), line,
        [this, line, bound] {
            if (!line->hasFocus()) {
                line->setText(numberListText(valueOf<std::vector<int>>(bound)));
            }
        },
        bound.isShown);
}

} // namespace crowd::widgets
