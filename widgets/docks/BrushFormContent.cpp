// SPDX-License-Identifier: MIT
#include <set>

#include <QtCore/QCoreApplication>

#include "widgets/docks/BrushForm.h"

namespace crowd::widgets {

namespace {

using model::BrushKind;
using model::BrushOperator;
using model::BrushSelection;
using model::BrushSettings;
using model::HeadingMode;
using model::HeadingSettings;

constexpr double kDegrees = 180.0 / 3.14159265358979;

float asFloat(double value)
{
    return static_cast<float>(value);
}

void addArea(BrushForm& form, BrushKind kind)
{
    form.addTitle(BrushForm::tr("Area"));
    form.addChoice(
        BrushForm::tr("Reaches"),
        {BrushForm::tr("One"), BrushForm::tr("Spray"), BrushForm::tr("All in circle"),
         BrushForm::tr("Rectangle")},
        [](const BrushSettings& s) { return static_cast<int>(s.selection); },
        [](BrushSettings& s, int i) { s.selection = static_cast<BrushSelection>(i); });
    form.addSlider(
        BrushForm::tr("Size"), {1.0, 400.0, 5.0, 0, BrushForm::tr(" px"), true},
        [](const BrushSettings& s) { return static_cast<double>(s.radiusPixels); },
        [](BrushSettings& s, double v) { s.radiusPixels = asFloat(v); },
        [](const BrushSettings& s) { return s.hasCircle(); });
    form.addSlider(
        BrushForm::tr("Rate"), {1.0, 500.0, 5.0, 0, BrushForm::tr(" /s"), true},
        [](const BrushSettings& s) { return static_cast<double>(s.ratePerSecond); },
        [](BrushSettings& s, double v) { s.ratePerSecond = asFloat(v); },
        [](const BrushSettings& s) { return s.selection == BrushSelection::Spray; });
    form.addCheck(
        BrushForm::tr("Pen pressure changes size"), {},
        [](const BrushSettings& s) { return s.pressureSize; },
        [](BrushSettings& s, bool on) { s.pressureSize = on; },
        [](const BrushSettings& s) { return s.hasCircle(); });
    if (kind != BrushKind::Create) {
        form.addCheck(
            BrushForm::tr("Through"),
            BrushForm::tr("Also people hidden behind others or the stage"),
            [](const BrushSettings& s) { return s.through; },
            [](BrushSettings& s, bool on) { s.through = on; });
    }
    if (kind == BrushKind::Colour || kind == BrushKind::Orientation ||
        kind == BrushKind::Animation) {
        form.addCheck(
            BrushForm::tr("Build up"), BrushForm::tr("Each dab changes again whom it touches"),
            [](const BrushSettings& s) { return s.buildUp; },
            [](BrushSettings& s, bool on) { s.buildUp = on; },
            [](const BrushSettings& s) { return s.selection != BrushSelection::Rectangle; });
    }
}

void addOperator(BrushForm& form)
{
    form.addTitle(BrushForm::tr("Operator"));
    form.addChoice(
        BrushForm::tr("Values"),
        {BrushForm::tr("Uniform"), BrushForm::tr("Random"), BrushForm::tr("Gradient")},
        [](const BrushSettings& s) { return static_cast<int>(s.op); },
        [](BrushSettings& s, int i) { s.op = static_cast<BrushOperator>(i); });
    form.addCurve([](const BrushSettings& s) { return s.distribution; },
                  [](BrushSettings& s, const model::DistributionCurve& c) { s.distribution = c; },
                  [](const BrushSettings& s) { return s.op == BrushOperator::Random; });
}

/// Two sliders for a range; the low one never passes the high one.
template<class GetRange>
void addRange(BrushForm& form, const QString& low, const QString& high,
              const ValueSlider::Range& range, GetRange get, const BrushForm::Condition& shown = {})
{
    form.addSlider(
        low, range,
        [get](const BrushSettings& s) {
            BrushSettings copy = s;
            return static_cast<double>(get(copy).low);
        },
        [get](BrushSettings& s, double v) {
            get(s).low = asFloat(v);
            get(s).high = std::max(get(s).high, get(s).low);
        },
        shown);
    form.addSlider(
        high, range,
        [get](const BrushSettings& s) {
            BrushSettings copy = s;
            return static_cast<double>(get(copy).high);
        },
        [get](BrushSettings& s, double v) {
            get(s).high = asFloat(v);
            get(s).low = std::min(get(s).high, get(s).low);
        },
        shown);
}

void addHeading(BrushForm& form, HeadingSettings& (*heading)(BrushSettings&))
{
    const auto of = [heading](const BrushSettings& s) {
        BrushSettings copy = s;
        return heading(copy);
    };
    form.addTitle(BrushForm::tr("Facing"));
    form.addChoice(
        BrushForm::tr("Towards"),
        {BrushForm::tr("A direction"), BrushForm::tr("Random"), BrushForm::tr("Along the stroke"),
         BrushForm::tr("A point"), BrushForm::tr("The viewer")},
        [of](const BrushSettings& s) { return static_cast<int>(of(s).mode); },
        [heading](BrushSettings& s, int i) { heading(s).mode = static_cast<HeadingMode>(i); });
    form.addSlider(
        BrushForm::tr("Direction"), {-180.0, 180.0, 5.0, 0, QStringLiteral("°"), false},
        [of](const BrushSettings& s) {
            return static_cast<double>(of(s).headingRadians) * kDegrees;
        },
        [heading](BrushSettings& s, double v) {
            heading(s).headingRadians = asFloat(v / kDegrees);
        },
        [of](const BrushSettings& s) {
            return of(s).mode == HeadingMode::Direction || of(s).mode == HeadingMode::Random;
        });
    form.addSlider(
        BrushForm::tr("Spread"), {0.0, 180.0, 5.0, 0, QStringLiteral("°"), false},
        [of](const BrushSettings& s) {
            return static_cast<double>(of(s).spreadRadians) * kDegrees;
        },
        [heading](BrushSettings& s, double v) { heading(s).spreadRadians = asFloat(v / kDegrees); },
        [of](const BrushSettings& s) { return of(s).mode == HeadingMode::Random; });
    for (int axis = 0; axis < 3; axis += 2) {
        form.addSlider(
            axis == 0 ? BrushForm::tr("Point X") : BrushForm::tr("Point Z"),
            {-100.0, 100.0, 0.5, 1, BrushForm::tr(" m"), false},
            [of, axis](const BrushSettings& s) {
                return static_cast<double>(of(s).towardsPoint[axis]);
            },
            [heading, axis](BrushSettings& s, double v) {
                heading(s).towardsPoint[axis] = asFloat(v);
            },
            [of](const BrushSettings& s) { return of(s).mode == HeadingMode::TowardsPoint; });
    }
}

void addCreation(BrushForm& form)
{
    const auto onSeats = [](const BrushSettings& s) { return s.create.seats.isOn; };
    const auto onGround = [](const BrushSettings& s) { return !s.create.seats.isOn; };
    const auto isRectangle = [](const BrushSettings& s) {
        return s.selection == BrushSelection::Rectangle;
    };
    form.addTitle(BrushForm::tr("Seats"));
    form.addCheck(
        BrushForm::tr("Only on free seats"),
        BrushForm::tr("Seat grid: people sit down where they may"),
        [](const BrushSettings& s) { return s.create.seats.isOn; },
        [](BrushSettings& s, bool on) { s.create.seats.isOn = on; });
    form.addNumberList(
        BrushForm::tr("Ranks"), BrushForm::tr("Rows counted from the front, as 1, 3-5"),
        [](const BrushSettings& s) { return s.create.seats.ranks; },
        [](BrushSettings& s, std::vector<int> v) { s.create.seats.ranks = std::move(v); }, onSeats);
    form.addNumberList(
        BrushForm::tr("Wedges"), BrushForm::tr("Wedges of seats, as 1, 3-5"),
        [](const BrushSettings& s) { return s.create.seats.wedges; },
        [](BrushSettings& s, std::vector<int> v) { s.create.seats.wedges = std::move(v); },
        onSeats);
    form.addSlider(
        BrushForm::tr("Of the seats"), {1.0, 100.0, 5.0, 0, QStringLiteral(" %"), false},
        [](const BrushSettings& s) { return static_cast<double>(s.create.seatPercent); },
        [](BrushSettings& s, double v) { s.create.seatPercent = asFloat(v); },
        [onSeats](const BrushSettings& s) { return onSeats(s); });
    form.addSlider(
        BrushForm::tr("Density"), {0.05, 6.0, 0.1, 2, BrushForm::tr(" /m²"), true},
        [](const BrushSettings& s) { return static_cast<double>(s.create.density); },
        [](BrushSettings& s, double v) { s.create.density = asFloat(v); },
        [onGround, isRectangle](const BrushSettings& s) { return onGround(s) && isRectangle(s); });
    form.addSlider(
        BrushForm::tr("Distance"), {0.1, 10.0, 0.1, 2, BrushForm::tr(" m"), true},
        [](const BrushSettings& s) { return static_cast<double>(s.create.minimalDistance); },
        [](BrushSettings& s, double v) { s.create.minimalDistance = asFloat(v); }, onGround);
    form.addTitle(BrushForm::tr("Variation"));
    addRange(form, BrushForm::tr("Height from"), BrushForm::tr("Height to"),
             {0.5, 2.0, 0.01, 2, {}, false},
             [](BrushSettings& s) -> model::ValueRange& { return s.create.height; });
    addRange(form, BrushForm::tr("Girth from"), BrushForm::tr("Girth to"),
             {0.5, 2.0, 0.01, 2, {}, false},
             [](BrushSettings& s) -> model::ValueRange& { return s.create.girth; });
    form.addSlider(
        BrushForm::tr("Colour"), {0.0, 100.0, 5.0, 0, QStringLiteral(" %"), false},
        [](const BrushSettings& s) {
            return static_cast<double>(s.create.paletteStrength) * 100.0;
        },
        [](BrushSettings& s, double v) { s.create.paletteStrength = asFloat(v / 100.0); });
    addRange(form, BrushForm::tr("Phase from"), BrushForm::tr("Phase to"),
             {0.0, 1.0, 0.05, 2, {}, false},
             [](BrushSettings& s) -> model::ValueRange& { return s.create.phase; });
    addHeading(form, [](BrushSettings& s) -> HeadingSettings& { return s.create.heading; });
    form.addTitle(BrushForm::tr("Clips (none: what suits)"));
    form.addClips(
        [](const BrushSettings& s) { return s.create.clips; },
        [](BrushSettings& s, std::vector<model::ClipWeight> v) { s.create.clips = std::move(v); });
}

void addColour(BrushForm& form, const EditorState& state)
{
    QStringList slots{BrushForm::tr("All tintable")};
    std::vector<std::string> names{std::string()};
    std::set<std::string> known;
    for (const model::TemplateEntry& entry : state.scene().templates) {
        for (std::size_t i = 0; entry.asset && i < entry.asset->slots.size(); ++i) {
            if (known.insert(entry.asset->slots[i].name).second) {
                names.push_back(entry.asset->slots[i].name);
                slots << QString::fromStdString(names.back());
            }
        }
    }
    form.addTitle(BrushForm::tr("Paint"));
    form.addChoice(
        BrushForm::tr("Slot"), slots,
        [names](const BrushSettings& s) {
            const auto found = std::ranges::find(names, s.colour.slot);
            return found == names.end() ? 0 : static_cast<int>(found - names.begin());
        },
        [names](BrushSettings& s, int i) { s.colour.slot = names[static_cast<std::size_t>(i)]; });
    form.addSlider(
        BrushForm::tr("Strength"), {0.0, 100.0, 5.0, 0, QStringLiteral(" %"), false},
        [](const BrushSettings& s) { return static_cast<double>(s.colour.strength) * 100.0; },
        [](BrushSettings& s, double v) { s.colour.strength = asFloat(v / 100.0); });
    const auto isRandom = [](const BrushSettings& s) { return s.op == BrushOperator::Random; };
    form.addCheck(
        BrushForm::tr("Blend between the colours"), {},
        [](const BrushSettings& s) { return s.colour.blends; },
        [](BrushSettings& s, bool on) { s.colour.blends = on; }, isRandom);
    form.addCheck(
        BrushForm::tr("Another colour for each slot"), {},
        [](const BrushSettings& s) { return s.colour.eachSlotApart; },
        [](BrushSettings& s, bool on) { s.colour.eachSlotApart = on; }, isRandom);
}

void addAnimation(BrushForm& form)
{
    form.addTitle(BrushForm::tr("Clips (none: as they are)"));
    form.addClips([](const BrushSettings& s) { return s.animation.clips; },
                  [](BrushSettings& s, std::vector<model::ClipWeight> v) {
                      s.animation.clips = std::move(v);
                  });
    form.addCheck(
        BrushForm::tr("Change the phase"), {},
        [](const BrushSettings& s) { return s.animation.setsPhase; },
        [](BrushSettings& s, bool on) { s.animation.setsPhase = on; });
    addRange(
        form, BrushForm::tr("Phase from"), BrushForm::tr("Phase to"),
        {0.0, 1.0, 0.05, 2, {}, false},
        [](BrushSettings& s) -> model::ValueRange& { return s.animation.phase; },
        [](const BrushSettings& s) { return s.animation.setsPhase; });
    form.addCheck(
        BrushForm::tr("Change the speed"), {},
        [](const BrushSettings& s) { return s.animation.setsSpeed; },
        [](BrushSettings& s, bool on) { s.animation.setsSpeed = on; });
    addRange(
        form, BrushForm::tr("Speed from"), BrushForm::tr("Speed to"),
        {0.1, 4.0, 0.05, 2, {}, false},
        [](BrushSettings& s) -> model::ValueRange& { return s.animation.speed; },
        [](const BrushSettings& s) { return s.animation.setsSpeed; });
}

} // namespace

void fillBrushForm(BrushForm& form, BrushKind kind, const EditorState& state)
{
    addArea(form, kind);
    switch (kind) {
    case BrushKind::Create:
        addCreation(form);
        break;
    case BrushKind::Delete:
        break;
    case BrushKind::Colour:
        addOperator(form);
        addColour(form, state);
        break;
    case BrushKind::Orientation:
        addOperator(form);
        addHeading(form,
                   [](BrushSettings& s) -> HeadingSettings& { return s.orientation.heading; });
        break;
    case BrushKind::Animation:
        addOperator(form);
        addAnimation(form);
        break;
    }
    form.finish();
}

} // namespace crowd::widgets
