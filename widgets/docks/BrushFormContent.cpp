// SPDX-License-Identifier: MIT
#include "widgets/docks/BrushFormParts.h"
#include "widgets/state/BrushTexts.h"

namespace crowd::widgets {

namespace {

using model::BrushKind;
using model::BrushOperator;
using model::BrushSelection;
using model::BrushSettings;
using model::HeadingSettings;

bool hasCircle(const BrushSettings& s)
{
    return s.hasCircle();
}

bool isSpray(const BrushSettings& s)
{
    return s.selection == BrushSelection::Spray;
}

bool isGradient(const BrushSettings& s)
{
    return s.op == BrushOperator::Gradient;
}

void addPressure(BrushForm& form)
{
    form.beginRow();
    form.addLabel(BrushForm::tr("Pen pressure"), hasCircle);
    addFlag(
        form, BrushForm::tr("Size"), BrushForm::tr("The harder the pen presses, the larger"),
        [](BrushSettings& s) -> bool& { return s.pressureSize; }, hasCircle);
    addFlag(
        form, BrushForm::tr("Rate"), BrushForm::tr("The harder the pen presses, the more"),
        [](BrushSettings& s) -> bool& { return s.pressureRate; }, isSpray);
    form.endRow();
}

void addArea(BrushForm& form)
{
    QStringList names;
    for (int i = 0; i <= static_cast<int>(BrushSelection::Rectangle); ++i) {
        names << selectionName(static_cast<BrushSelection>(i));
    }
    form.beginSection(BrushForm::tr("Brush"), QStringLiteral("area"));
    form.addChoice(
        BrushForm::tr("Area"), names,
        [](const BrushSettings& s) { return static_cast<int>(s.selection); },
        [](BrushSettings& s, int i) { s.selection = static_cast<BrushSelection>(i); });
    addFloat(
        form, BrushForm::tr("Size"), {1.0, 400.0, 5.0, 0, BrushForm::tr(" px"), true}, 1.0,
        [](BrushSettings& s) -> float& { return s.radiusPixels; }, hasCircle);
    addFloat(
        form, BrushForm::tr("Rate"), {1.0, 500.0, 5.0, 0, BrushForm::tr(" /s"), true}, 1.0,
        [](BrushSettings& s) -> float& { return s.ratePerSecond; }, isSpray);
    addPressure(form);
}

void addReach(BrushForm& form, BrushKind kind)
{
    const auto isDabbed = [](const BrushSettings& s) {
        return s.selection != BrushSelection::Rectangle && !isGradient(s);
    };
    form.beginRow();
    addThrough(form, BrushForm::tr("Also characters hidden behind others or the stage"));
    if (kind == BrushKind::Colour || kind == BrushKind::Orientation ||
        kind == BrushKind::Animation) {
        addFlag(
            form, BrushForm::tr("Build up"),
            BrushForm::tr("Each dab changes again whom it touches"),
            [](BrushSettings& s) -> bool& { return s.buildUp; }, isDabbed);
    }
    form.endRow();
    if (kind == BrushKind::Colour || kind == BrushKind::Orientation) {
        addFloat(
            form, BrushForm::tr("Flow"), {1.0, 100.0, 5.0, 0, QStringLiteral(" %"), false}, 100.0,
            [](BrushSettings& s) -> float& { return s.flow; },
            [isDabbed](const BrushSettings& s) { return s.buildUp && isDabbed(s); });
    }
}

void addOperator(BrushForm& form, const QString& gradientNote)
{
    form.beginSection(BrushForm::tr("Operator"), QStringLiteral("operator"));
    form.addChoice(
        BrushForm::tr("Values"),
        {BrushForm::tr("Uniform"), BrushForm::tr("Random"), BrushForm::tr("Gradient")},
        [](const BrushSettings& s) { return static_cast<int>(s.op); },
        [](BrushSettings& s, int i) { s.op = static_cast<BrushOperator>(i); });
    form.addCurve([](const BrushSettings& s) { return s.distribution; },
                  [](BrushSettings& s, const model::DistributionCurve& c) { s.distribution = c; },
                  isRandom);
    form.addNote(gradientNote, isGradient);
}

} // namespace

void addFloat(BrushForm& form, const QString& label, const ValueSlider::Range& range, double scale,
              float& (*value)(BrushSettings&), const BrushForm::Condition& isShown)
{
    form.addSlider(
        label, range,
        [value, scale](BrushSettings s) { return static_cast<double>(value(s)) * scale; },
        [value, scale](BrushSettings& s, double v) { value(s) = asFloat(v / scale); }, isShown);
}

void addFlag(BrushForm& form, const QString& label, const QString& tip,
             bool& (*value)(BrushSettings&), const BrushForm::Condition& isShown)
{
    form.addCheck(
        label, tip, [value](BrushSettings s) { return value(s); },
        [value](BrushSettings& s, bool on) { value(s) = on; }, isShown);
}

void addThrough(BrushForm& form, const QString& tip, const BrushForm::Condition& isShown)
{
    addFlag(
        form, BrushForm::tr("Through"), tip, [](BrushSettings& s) -> bool& { return s.through; },
        isShown);
}

void fillBrushForm(BrushForm& form, BrushKind kind, EditorState& state)
{
    if (kind != BrushKind::Path && kind != BrushKind::Environment) {
        addArea(form);
    }
    if (kind != BrushKind::Create && kind != BrushKind::Path && kind != BrushKind::Environment) {
        addReach(form, kind);
    }
    switch (kind) {
    case BrushKind::Create:
        addCreation(form, state);
        break;
    case BrushKind::Delete:
        addFloat(
            form, BrushForm::tr("Of them"), {5.0, 100.0, 5.0, 0, QStringLiteral(" %"), false}, 1.0,
            [](BrushSettings& s) -> float& { return s.removal.percent; },
            [](const BrushSettings& s) { return s.takesShare(); });
        break;
    case BrushKind::Colour:
        addColour(form, state);
        addOperator(form, BrushForm::tr("From the first to the last colour along the line."));
        break;
    case BrushKind::Orientation:
        addOperator(form, BrushForm::tr("They face along the line that is drawn."));
        addHeading(
            form, state, [](BrushSettings& s) -> HeadingSettings& { return s.orientation.heading; },
            [](const BrushSettings& s) { return !isGradient(s); });
        break;
    case BrushKind::Animation:
        addAnimation(form);
        addOperator(form, BrushForm::tr("From the lower to the higher values along the line."));
        break;
    case BrushKind::Walk:
        addWalk(form, state);
        break;
    case BrushKind::Style:
        addStyle(form);
        addOperator(form, BrushForm::tr("From the slower to the faster along the line."));
        break;
    case BrushKind::Tag:
    case BrushKind::Untag:
        addTag(form, state);
        break;
    case BrushKind::Event:
        addEvent(form, state);
        break;
    case BrushKind::Path:
    case BrushKind::Environment:
        addPlaces(form, kind);
        break;
    case BrushKind::Script:
        addScriptSettings(form, state);
        break;
    }
    form.finish();
}

} // namespace crowd::widgets
