// SPDX-License-Identifier: MIT
#include "widgets/forms/FieldControls.h"

#include <cmath>

#include <glm/common.hpp>

#include <QtCore/QPointer>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QColorDialog>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>

#include "widgets/forms/ColourRow.h"
#include "widgets/forms/CurveEditor.h"
#include "widgets/forms/FieldReferences.h"
#include "widgets/forms/NumberList.h"
#include "widgets/forms/RangeSlider.h"
#include "widgets/forms/StatureNote.h"
#include "widgets/state/BrushTexts.h"

namespace crowd::widgets {

using Bound = FieldForm::Bound;
using model::FieldMeta;

namespace {

QString labelOf(const Bound& bound)
{
    return fieldText(bound.field->meta.label);
}

QString tipTextOf(const Bound& bound)
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

void addNumber(FieldForm& form, const Bound& bound, double low, double high)
{
    ValueSlider::Range range = controlRange(bound.field->meta);
    range.low = low;
    range.high = high;
    if (form.context().brush == nullptr) { // of brushes an artist means no more than the bar has
        range.least = bound.field->meta.low * bound.field->meta.shownScale;
        range.most = bound.field->meta.high * bound.field->meta.shownScale;
    }
    const double scale = bound.field->meta.shownScale;
    const auto get = [&form, bound, scale] {
        return std::visit(
            [scale](const auto& number) {
                if constexpr (std::is_arithmetic_v<std::decay_t<decltype(number)>>) {
                    return static_cast<double>(number) * scale;
                } else {
                    return 0.0;
                }
            },
            form.value(bound));
    };
    const auto set = [&form, bound, scale](double shown) {
        if (bound.field->is<std::int64_t>()) {
            form.setValue(bound, static_cast<std::int64_t>(std::llround(shown / scale)));
        } else if (bound.field->is<double>()) {
            form.setValue(bound, shown / scale);
        } else {
            form.setValue(bound, static_cast<float>(shown / scale));
        }
    };
    form.addSlider(labelOf(bound), range, get, set, bound.isShown);
}

void addFlag(FieldForm& form, const Bound& bound)
{
    auto* box = new QCheckBox(labelOf(bound), &form);
    box->setToolTip(tipTextOf(bound));
    const bool isOptional = bound.field->is<std::optional<bool>>();
    QObject::connect(box, &QCheckBox::clicked, &form, [&form, bound, isOptional](bool on) {
        form.setValue(bound, isOptional ? model::FieldValue(std::optional<bool>(on))
                                        : model::FieldValue(on));
    });
    form.bind(
        box,
        [&form, box, bound, isOptional] {
            box->setChecked(isOptional ? form.valueOf<std::optional<bool>>(bound).value_or(true)
                                       : form.valueOf<bool>(bound));
        },
        bound.isShown);
}

void addChoices(FieldForm& form, const Bound& bound)
{
    const auto choices = bound.field->meta.choices;
    const bool isFlag = bound.field->is<bool>();
    QStringList names;
    QStringList tips;
    for (const model::FieldChoice& choice : choices) {
        names << fieldText(choice.label);
        tips << (*choice.tip != 0 ? fieldText(choice.tip) : QString());
    }
    const auto chosen = [&form, bound, isFlag] {
        return isFlag ? static_cast<int>(form.valueOf<bool>(bound))
                      : static_cast<int>(form.valueOf<std::int64_t>(bound));
    };
    form.addChoice(
        labelOf(bound), names, chosen,
        [&form, bound, isFlag](int index) {
            form.setValue(bound, isFlag ? model::FieldValue(index == 1)
                                        : model::FieldValue(static_cast<std::int64_t>(index)));
        },
        bound.isShown, tips);
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (*choices[i].tip != '\0') {
            form.addNote(fieldText(choices[i].tip), [bound, chosen, i] {
                return (!bound.isShown || bound.isShown()) && chosen() == static_cast<int>(i);
            });
        }
    }
}

void addTextChoices(FieldForm& form, const Bound& bound)
{
    QStringList names;
    QStringList keys;
    for (const model::FieldChoice& choice : bound.field->meta.choices) {
        names << fieldText(choice.label);
        keys << QString::fromUtf8(choice.key);
    }
    form.addChoice(
        labelOf(bound), names,
        [&form, bound, keys] {
            return static_cast<int>(
                keys.indexOf(QString::fromStdString(form.valueOf<std::string>(bound))));
        },
        [&form, bound, keys](int index) { form.setValue(bound, keys[index].toStdString()); },
        bound.isShown);
}

void addText(FieldForm& form, const Bound& bound)
{
    auto* line = new QLineEdit(&form);
    line->setObjectName(QStringLiteral("brushText"));
    line->setToolTip(tipTextOf(bound));
    QObject::connect(line, &QLineEdit::textEdited, &form, [&form, bound](const QString& text) {
        form.setValue(bound, text.toStdString());
    });
    form.addLabelled(
        labelOf(bound), line,
        [&form, line, bound] {
            if (!line->hasFocus()) {
                line->setText(QString::fromStdString(form.valueOf<std::string>(bound)));
            }
        },
        bound.isShown);
}

void addRange(FieldForm& form, const Bound& bound)
{
    const ValueSlider::Range range = controlRange(bound.field->meta);
    const auto scale = static_cast<float>(bound.field->meta.shownScale);
    auto* slider = new RangeSlider(labelOf(bound), range, &form);
    QObject::connect(
        slider, &RangeSlider::valueEdited, &form,
        [&form, bound, scale](const model::ValueRange& edited) {
            form.setValue(bound, model::ValueRange{edited.low / scale, edited.high / scale});
        });
    form.bind(
        slider,
        [&form, slider, bound, scale] {
            const auto shown = form.valueOf<model::ValueRange>(bound);
            slider->setValue({shown.low * scale, shown.high * scale});
        },
        bound.isShown);
    if (bound.field->meta.role == model::FieldRole::Stature) {
        addStatureNote(form, bound);
    }
}

/// What is looked at in the dialog is seen in the scene, where that is one step with what is
/// chosen.
void chooseColour(FieldForm& form, const QString& label, const std::function<QColor()>& get,
                  const std::function<void(const QColor&)>& set)
{
    const QColor before = get();
    QColorDialog dialog(before, form.window()); // the form may be made anew meanwhile
    dialog.setWindowTitle(label);
    dialog.setOption(QColorDialog::DontUseNativeDialog);
    Q_EMIT form.held(true);
    if (form.isHeldTogether()) {
        QObject::connect(&dialog, &QColorDialog::currentColorChanged, &form, set);
    }
    const QPointer<FieldForm> stillThere(&form);
    const bool isChosen = dialog.exec() == QDialog::Accepted;
    if (!stillThere) {
        return;
    }
    if (isChosen || form.isHeldTogether()) {
        set(isChosen ? dialog.selectedColor() : before);
    }
    Q_EMIT form.held(false);
}

/// Opens the dialog of colours; `get` and `set` are of the field.
void addColourButton(FieldForm& form, const Bound& bound, const std::function<QColor()>& get,
                     const std::function<void(const QColor&)>& set)
{
    auto* button = new QToolButton(&form);
    const QString label = labelOf(bound);
    button->setAccessibleName(label);
    button->setToolTip(tipTextOf(bound));
    QObject::connect(button, &QToolButton::clicked, &form,
                     [&form, label, get, set] { chooseColour(form, label, get, set); });
    form.addLabelled(
        label, button,
        [button, get] {
            QPixmap swatch(32, 14);
            swatch.fill(get());
            button->setIconSize(swatch.size());
            button->setIcon(swatch);
        },
        bound.isShown);
}

void addColour(FieldForm& form, const Bound& bound)
{
    addColourButton(
        form, bound,
        [&form, bound] {
            const auto now = form.valueOf<model::PaintColor>(bound);
            return QColor(now[0], now[1], now[2]);
        },
        [&form, bound](const QColor& chosen) {
            form.setValue(bound, model::PaintColor{static_cast<std::uint8_t>(chosen.red()),
                                                   static_cast<std::uint8_t>(chosen.green()),
                                                   static_cast<std::uint8_t>(chosen.blue())});
        });
}

/// Of floats.
void addFineColour(FieldForm& form, const Bound& bound)
{
    addColourButton(
        form, bound,
        [&form, bound] {
            const auto now = glm::clamp(form.valueOf<glm::vec3>(bound), 0.0F, 1.0F);
            return QColor::fromRgbF(now.x, now.y, now.z);
        },
        [&form, bound](const QColor& chosen) {
            form.setValue(bound, glm::vec3(chosen.redF(), chosen.greenF(), chosen.blueF()));
        });
}

void addColours(FieldForm& form, const Bound& bound)
{
    auto* row = new ColourRow(labelOf(bound), &form);
    row->setToolTip(tipTextOf(bound));
    QObject::connect(row, &ColourRow::edited, &form,
                     [&form, bound](const ColourRow::Colours& all) { form.setValue(bound, all); });
    form.addLabelled(
        labelOf(bound), row,
        [&form, row, bound] {
            row->setColours(form.valueOf<std::vector<model::PaintColor>>(bound));
        },
        bound.isShown);
}

void addCurve(FieldForm& form, const Bound& bound)
{
    auto* curve = new CurveEditor(&form);
    curve->setToolTip(tipTextOf(bound));
    QObject::connect(curve, &CurveEditor::edited, &form,
                     [&form, curve, bound] { form.setValue(bound, curve->curve()); });
    form.addLabelled(
        labelOf(bound), curve,
        [&form, curve, bound] { curve->setCurve(form.valueOf<model::DistributionCurve>(bound)); },
        bound.isShown);
}

void addNumberList(FieldForm& form, const Bound& bound)
{
    auto* line = new QLineEdit(&form);
    line->setMinimumWidth(40);
    line->setPlaceholderText(FieldForm::tr("all"));
    line->setToolTip(tipTextOf(bound));
    QObject::connect(line, &QLineEdit::editingFinished, &form,
                     [&form, line, bound] { form.setValue(bound, numberListOf(line->text())); });
    form.addLabelled(
        labelOf(bound), line,
        [&form, line, bound] {
            if (!line->hasFocus()) {
                line->setText(numberListText(form.valueOf<std::vector<int>>(bound)));
            }
        },
        bound.isShown);
}

} // namespace

void addControl(FieldForm& form, const Bound& bound)
{
    using namespace model;
    const FieldInfo& field = *bound.field;
    if (addReferenceControl(form, bound)) {
        return;
    }
    if (!field.meta.choices.empty()) {
        field.is<std::string>() ? addTextChoices(form, bound) : addChoices(form, bound);
    } else if (field.is<bool>() || field.is<std::optional<bool>>()) {
        addFlag(form, bound);
    } else if (field.is<float>() || field.is<double>() || field.is<std::int64_t>()) {
        const ValueSlider::Range range = controlRange(field.meta);
        addNumber(form, bound, range.low, range.high);
    } else if (field.is<ValueRange>()) {
        addRange(form, bound);
    } else if (field.is<std::string>()) {
        addText(form, bound);
    } else if (field.is<PaintColor>()) {
        addColour(form, bound);
    } else if (field.meta.role == FieldRole::Color) {
        addFineColour(form, bound);
    } else if (field.is<std::vector<PaintColor>>()) {
        addColours(form, bound);
    } else if (field.is<DistributionCurve>()) {
        addCurve(form, bound);
    } else if (field.is<std::vector<int>>()) {
        addNumberList(form, bound);
    }
}

} // namespace crowd::widgets
