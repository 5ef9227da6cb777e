// SPDX-License-Identifier: MIT
#include "widgets/docks/BrushFormParts.h"

namespace crowd::widgets {

namespace {

using model::BrushKind;
using model::BrushSettings;
using model::HeadingMode;
using model::HeadingSettings;

constexpr double kDegrees = 180.0 / 3.14159265358979;
const ValueSlider::Range kAngle{-180.0, 180.0, 5.0, 0, QStringLiteral("°"), false};

void addPoint(BrushForm& form, EditorState& state, Heading heading,
              const BrushForm::Condition& isShown)
{
    form.beginRow();
    for (const int axis : {0, 2}) {
        form.addSlider(
            axis == 0 ? QStringLiteral("X") : QStringLiteral("Z"),
            {-100.0, 100.0, 0.5, 1, BrushForm::tr(" m"), false},
            [heading, axis](BrushSettings s) {
                return static_cast<double>(heading(s).towardsPoint[axis]);
            },
            [heading, axis](BrushSettings& s, double v) {
                heading(s).towardsPoint[axis] = asFloat(v);
            },
            isShown);
    }
    form.endRow();
    form.addButton(
        BrushForm::tr("Choose in the Picture"), BrushForm::tr("Then click the point to face"),
        [&state] { state.setPicking(Picking::Point); }, isShown);
}

} // namespace

void addHeading(BrushForm& form, EditorState& state, Heading heading,
                const BrushForm::Condition& isShown)
{
    const auto modeIs = [heading, isShown](auto... modes) {
        return [=](BrushSettings s) { return isShown(s) && ((heading(s).mode == modes) || ...); };
    };
    const auto spreads = [heading, isShown](BrushSettings s) {
        const bool isTurned = s.kind == BrushKind::Orientation && isRandom(s);
        return isShown(s) && (heading(s).mode == HeadingMode::Random || isTurned);
    };
    using enum HeadingMode;
    form.beginSection(BrushForm::tr("Facing"), QStringLiteral("facing"));
    form.addChoice(
        BrushForm::tr("Towards"),
        {BrushForm::tr("A direction"), BrushForm::tr("Random"), BrushForm::tr("Along the stroke"),
         BrushForm::tr("A point"), BrushForm::tr("The viewer")},
        [heading](BrushSettings s) { return static_cast<int>(heading(s).mode); },
        [heading](BrushSettings& s, int i) { heading(s).mode = static_cast<HeadingMode>(i); },
        isShown);
    const auto addAngle = [&](const QString& label, const ValueSlider::Range& range,
                              float HeadingSettings::*value, const BrushForm::Condition& shown) {
        form.addSlider(
            label, range,
            [heading, value](BrushSettings s) {
                return static_cast<double>(heading(s).*value) * kDegrees;
            },
            [heading, value](BrushSettings& s, double v) {
                heading(s).*value = asFloat(v / kDegrees);
            },
            shown);
    };
    addPoint(form, state, heading, modeIs(TowardsPoint));
    addAngle(BrushForm::tr("Direction"), kAngle, &HeadingSettings::headingRadians,
             modeIs(Direction, Random));
    addAngle(BrushForm::tr("Turned by"), kAngle, &HeadingSettings::turnRadians,
             modeIs(AlongStroke, TowardsPoint, TowardsViewer));
    addAngle(BrushForm::tr("Spread"), {0.0, 180.0, 5.0, 0, QStringLiteral("°"), false},
             &HeadingSettings::spreadRadians, spreads);
}

} // namespace crowd::widgets
