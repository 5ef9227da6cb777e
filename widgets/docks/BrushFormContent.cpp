// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include <QtCore/QCoreApplication>

#include "model/scene/NearestPath.h"
#include "widgets/docks/BrushForm.h"
#include "widgets/state/BrushTexts.h"

namespace crowd::widgets {

namespace {

using model::BrushKind;
using model::BrushOperator;
using model::BrushSelection;
using model::BrushSettings;
using model::HeadingMode;
using model::HeadingSettings;
using model::ValueRange;

using Heading = HeadingSettings& (*)(BrushSettings&);

constexpr double kDegrees = 180.0 / 3.14159265358979;
const ValueSlider::Range kPercent{0.0, 100.0, 5.0, 0, QStringLiteral(" %"), false};
const ValueSlider::Range kAngle{-180.0, 180.0, 5.0, 0, QStringLiteral("°"), false};

float asFloat(double value)
{
    return static_cast<float>(value);
}

bool hasCircle(const BrushSettings& s)
{
    return s.hasCircle();
}

bool isSpray(const BrushSettings& s)
{
    return s.selection == BrushSelection::Spray;
}

bool isArea(const BrushSettings& s)
{
    return s.selection == BrushSelection::AllInCircle || s.selection == BrushSelection::Rectangle;
}

bool isRandom(const BrushSettings& s)
{
    return s.op == BrushOperator::Random;
}

bool isGradient(const BrushSettings& s)
{
    return s.op == BrushOperator::Gradient;
}

/// A slider over a float that is shown as a multiple of what is stored.
void addFloat(BrushForm& form, const QString& label, const ValueSlider::Range& range, double scale,
              float& (*value)(BrushSettings&), const BrushForm::Condition& isShown = {})
{
    form.addSlider(
        label, range,
        [value, scale](BrushSettings s) { return static_cast<double>(value(s)) * scale; },
        [value, scale](BrushSettings& s, double v) { value(s) = asFloat(v / scale); }, isShown);
}

void addFlag(BrushForm& form, const QString& label, const QString& tip,
             bool& (*value)(BrushSettings&), const BrushForm::Condition& isShown = {})
{
    form.addCheck(
        label, tip, [value](BrushSettings s) { return value(s); },
        [value](BrushSettings& s, bool on) { value(s) = on; }, isShown);
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
    form.beginSection(BrushForm::tr("Area"), QStringLiteral("area"));
    form.addChoice(
        BrushForm::tr("Reaches"), names,
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

void addThrough(BrushForm& form, const QString& tip, const BrushForm::Condition& isShown = {})
{
    addFlag(
        form, BrushForm::tr("Through"), tip, [](BrushSettings& s) -> bool& { return s.through; },
        isShown);
}

void addReach(BrushForm& form, BrushKind kind)
{
    const auto isDabbed = [](const BrushSettings& s) {
        return s.selection != BrushSelection::Rectangle && !isGradient(s);
    };
    form.beginRow();
    addThrough(form, BrushForm::tr("Also people hidden behind others or the stage"));
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

void addSeats(BrushForm& form, const BrushForm::Condition& onSeats)
{
    form.addNumberLists(
        {{BrushForm::tr("Ranks"), BrushForm::tr("Rows counted from the front, as 1, 3-5"),
          [](BrushSettings& s) -> std::vector<int>& { return s.create.seats.ranks; }},
         {BrushForm::tr("Wedges"), BrushForm::tr("Wedges of seats, as 1, 3-5"),
          [](BrushSettings& s) -> std::vector<int>& { return s.create.seats.wedges; }}},
        onSeats);
    addFloat(
        form, BrushForm::tr("Of the seats"), {1.0, 100.0, 5.0, 0, QStringLiteral(" %"), false}, 1.0,
        [](BrushSettings& s) -> float& { return s.create.seatPercent; },
        [onSeats](const BrushSettings& s) { return onSeats(s) && s.takesShare(); });
}

/// Whether any template of the scene has something of the kind.
template<class Has>
bool anyTemplate(const EditorState& state, const Has& has)
{
    return std::ranges::any_of(state.scene().templates, [&](const model::TemplateEntry& entry) {
        return entry.asset && has(*entry.asset);
    });
}

void addClothes(BrushForm& form, const EditorState& state)
{
    const bool hasOutfits = anyTemplate(state, [](const model::Template& asset) {
        return std::ranges::any_of(asset.slots,
                                   [](const auto& slot) { return slot.choices.size() > 1; });
    });
    const bool hasParts =
        anyTemplate(state, [](const model::Template& asset) { return !asset.parts.empty(); });
    form.beginRow();
    addFlag(
        form, BrushForm::tr("Outfits"),
        BrushForm::tr("Each wears any of the materials that the template has for a slot"),
        [](BrushSettings& s) -> bool& { return s.create.variesOutfit; },
        [hasOutfits](const BrushSettings&) { return hasOutfits; });
    addFlag(
        form, BrushForm::tr("Parts"),
        BrushForm::tr("Each wears some of the template's parts, as hats and bags"),
        [](BrushSettings& s) -> bool& { return s.create.variesParts; },
        [hasParts](const BrushSettings&) { return hasParts; });
    form.endRow();
}

void addVariation(BrushForm& form, const EditorState& state)
{
    const ValueSlider::Range scale{0.5, 2.0, 0.01, 2, {}, false};
    form.beginSection(BrushForm::tr("Variation"), QStringLiteral("variation"));
    form.addRange(BrushForm::tr("Height"), scale,
                  [](BrushSettings& s) -> ValueRange& { return s.create.height; });
    form.addRange(BrushForm::tr("Girth"), scale,
                  [](BrushSettings& s) -> ValueRange& { return s.create.girth; });
    form.addRange(BrushForm::tr("Phase"), {0.0, 1.0, 0.05, 2, {}, false},
                  [](BrushSettings& s) -> ValueRange& { return s.create.phase; });
    addFloat(form, BrushForm::tr("Tint"), kPercent, 100.0,
             [](BrushSettings& s) -> float& { return s.create.paletteStrength; });
    addClothes(form, state);
    form.addCurve([](const BrushSettings& s) { return s.distribution; },
                  [](BrushSettings& s, const model::DistributionCurve& c) {
                      s.distribution = c;
                      s.op = BrushOperator::Random;
                  });
}

void addCreation(BrushForm& form, EditorState& state)
{
    const bool hasSeats = std::ranges::any_of(state.scene().stages, [](const auto& stage) {
        return stage.asset && !stage.asset->seats.empty();
    });
    const auto onSeats = [hasSeats](const BrushSettings& s) {
        return hasSeats && s.create.seats.isOn;
    };
    const auto onGround = [onSeats](const BrushSettings& s) { return !onSeats(s); };
    addThrough(form, BrushForm::tr("Also places hidden behind the stage"),
               [onSeats](const BrushSettings& s) { return onSeats(s) || isArea(s); });
    form.beginSection(BrushForm::tr("Places"), QStringLiteral("seats"));
    addFlag(
        form, BrushForm::tr("Only on free seats"),
        BrushForm::tr("Seat grid: people sit down where they may"),
        [](BrushSettings& s) -> bool& { return s.create.seats.isOn; },
        [hasSeats](const BrushSettings&) { return hasSeats; });
    addSeats(form, onSeats);
    addFloat(
        form, BrushForm::tr("Density"), {0.05, 6.0, 0.1, 2, BrushForm::tr(" /m²"), true}, 1.0,
        [](BrushSettings& s) -> float& { return s.create.density; },
        [onGround](const BrushSettings& s) { return onGround(s) && isArea(s); });
    addFloat(
        form, BrushForm::tr("Distance"), {0.1, 10.0, 0.1, 2, BrushForm::tr(" m"), true}, 1.0,
        [](BrushSettings& s) -> float& { return s.create.minimalDistance; }, onGround);
    addVariation(form, state);
    addHeading(
        form, state, [](BrushSettings& s) -> HeadingSettings& { return s.create.heading; },
        onGround);
    form.beginSection(BrushForm::tr("Clips (none: what suits)"), QStringLiteral("clips"));
    form.addClips([](BrushSettings & s) -> auto& { return s.create.clips; });
}

/// Names of all slots of the scene's templates, each once; the first is empty: all tintable.
std::vector<std::string> slotNames(const model::Scene& scene)
{
    std::vector<std::string> names{std::string()};
    std::set<std::string> known;
    for (const model::TemplateEntry& entry : scene.templates) {
        for (std::size_t i = 0; entry.asset && i < entry.asset->slots.size(); ++i) {
            if (known.insert(entry.asset->slots[i].name).second) {
                names.push_back(entry.asset->slots[i].name);
            }
        }
    }
    return names;
}

void addColour(BrushForm& form, const EditorState& state)
{
    const std::vector<std::string> names = slotNames(state.scene());
    QStringList texts{BrushForm::tr("All tintable")};
    for (std::size_t i = 1; i < names.size(); ++i) {
        texts << QString::fromStdString(names[i]);
    }
    form.beginSection(BrushForm::tr("Paint"), QStringLiteral("paint"));
    form.addChoice(
        BrushForm::tr("Slot"), texts,
        [names](const BrushSettings& s) {
            const auto found = std::ranges::find(names, s.colour.slot);
            return found == names.end() ? 0 : static_cast<int>(found - names.begin());
        },
        [names](BrushSettings& s, int i) { s.colour.slot = names[static_cast<std::size_t>(i)]; });
    addFloat(form, BrushForm::tr("Strength"), kPercent, 100.0,
             [](BrushSettings& s) -> float& { return s.colour.strength; });
    addFlag(
        form, BrushForm::tr("Blend the colours"),
        BrushForm::tr("Also what lies between the colours, not only one of them"),
        [](BrushSettings& s) -> bool& { return s.colour.blends; }, isRandom);
    addFlag(
        form, BrushForm::tr("Each slot its own"),
        BrushForm::tr("Another colour for each slot of a person"),
        [](BrushSettings& s) -> bool& { return s.colour.eachSlotApart; }, isRandom);
}

void addAnimation(BrushForm& form)
{
    form.beginSection(BrushForm::tr("Clips (none: as they are)"), QStringLiteral("clips"));
    form.addClips([](BrushSettings & s) -> auto& { return s.animation.clips; });
    form.beginSection(BrushForm::tr("Timing"), QStringLiteral("timing"));
    addFlag(form, BrushForm::tr("Change the phase"), {},
            [](BrushSettings& s) -> bool& { return s.animation.setsPhase; });
    form.addRange(
        BrushForm::tr("Phase"), {0.0, 1.0, 0.05, 2, {}, false},
        [](BrushSettings& s) -> ValueRange& { return s.animation.phase; },
        [](const BrushSettings& s) { return s.animation.setsPhase; });
    addFlag(form, BrushForm::tr("Change the speed"), {},
            [](BrushSettings& s) -> bool& { return s.animation.setsSpeed; });
    form.addRange(
        BrushForm::tr("Speed"), {0.0, 4.0, 0.05, 2, {}, false},
        [](BrushSettings& s) -> ValueRange& { return s.animation.speed; },
        [](const BrushSettings& s) { return s.animation.setsSpeed; });
}

void addWalk(BrushForm& form, const EditorState& state)
{
    QStringList names{BrushForm::tr("None: stay"), BrushForm::tr("The nearest")};
    std::vector<model::PathId> ids{0, model::kNearestPath};
    for (const model::Path& path : state.scene().paths) {
        names << QString::fromStdString(path.name);
        ids.push_back(path.id);
    }
    form.beginSection(BrushForm::tr("Path"), QStringLiteral("path"));
    addFlag(form, BrushForm::tr("Change the path"),
            BrushForm::tr("People walk along it when it plays"),
            [](BrushSettings& s) -> bool& { return s.walk.setsPath; });
    form.addChoice(
        BrushForm::tr("Follow"), names,
        [ids](const BrushSettings& s) {
            const auto found = std::ranges::find(ids, s.walk.path);
            return found == ids.end() ? 0 : static_cast<int>(found - ids.begin());
        },
        [ids](BrushSettings& s, int i) { s.walk.path = ids[static_cast<std::size_t>(i)]; },
        [](const BrushSettings& s) { return s.walk.setsPath; });
    form.beginSection(BrushForm::tr("Speed"), QStringLiteral("speed"));
    addFlag(form, BrushForm::tr("Change the speed"), {},
            [](BrushSettings& s) -> bool& { return s.walk.setsSpeed; });
    form.addRange(
        BrushForm::tr("Walking"), {0.0, 6.0, 0.1, 2, BrushForm::tr(" m/s"), false},
        [](BrushSettings& s) -> ValueRange& { return s.walk.speed; },
        [](const BrushSettings& s) { return s.walk.setsSpeed; });
}

void addStyle(BrushForm& form)
{
    form.beginSection(BrushForm::tr("Walk with"), QStringLiteral("style"));
    addFlag(form, BrushForm::tr("Change how they walk"),
            BrushForm::tr("With which clip people walk. None: what fits the speed. A clip that "
                          "stays in place is left out."),
            [](BrushSettings& s) -> bool& { return s.style.setsStyle; });
    form.addClips(
        [](BrushSettings & s) -> auto& { return s.style.clips; }, ClipsOnOffer::Moving);
    form.beginSection(BrushForm::tr("Speed"), QStringLiteral("speed"));
    addFlag(form, BrushForm::tr("Change the speed"), {},
            [](BrushSettings& s) -> bool& { return s.style.setsSpeed; });
    form.addRange(
        BrushForm::tr("Walking"), {0.0, 6.0, 0.1, 2, BrushForm::tr(" m/s"), false},
        [](BrushSettings& s) -> ValueRange& { return s.style.speed; },
        [](const BrushSettings& s) { return s.style.setsSpeed; });
}

void addTag(BrushForm& form, const EditorState& state)
{
    form.beginSection(BrushForm::tr("Tag"), QStringLiteral("tag"));
    form.addSlider(
        BrushForm::tr("Tag"), {1.0, 64.0, 1.0, 0, {}, false},
        [](const BrushSettings& s) { return s.tag.tag + 1.0; },
        [](BrushSettings& s, double v) { s.tag.tag = static_cast<std::uint8_t>(v - 1.0); });
    const std::vector<model::TagName>& tags = state.scene().tags;
    if (tags.empty()) {
        return;
    }
    QStringList names;
    std::vector<std::uint8_t> bits;
    for (const model::TagName& tag : tags) {
        names << QString::fromStdString(tag.name);
        bits.push_back(tag.bit);
    }
    form.addChoice(
        BrushForm::tr("Named"), names,
        [bits](const BrushSettings& s) {
            const auto found = std::ranges::find(bits, s.tag.tag);
            return found == bits.end() ? -1 : static_cast<int>(found - bits.begin());
        },
        [bits](BrushSettings& s, int i) { s.tag.tag = bits[static_cast<std::size_t>(i)]; });
}

void addEvent(BrushForm& form, const EditorState& state)
{
    form.beginSection(BrushForm::tr("Event"), QStringLiteral("event"));
    form.addText(
        BrushForm::tr("Name"), [](const BrushSettings& s) { return s.event.name; },
        [](BrushSettings& s, const std::string& text) { s.event.name = text; });
    QStringList names;
    for (const model::Rule& rule : state.scene().rules) {
        const QString name = QString::fromStdString(rule.trigger.event);
        if (rule.trigger.kind == model::TriggerKind::Event && !names.contains(name)) {
            names << name;
        }
    }
    if (!names.isEmpty()) {
        form.addChoice(
            BrushForm::tr("Known"), names,
            [names](const BrushSettings& s) {
                return static_cast<int>(names.indexOf(QString::fromStdString(s.event.name)));
            },
            [names](BrushSettings& s, int i) { s.event.name = names[i].toStdString(); });
    }
    addFloat(form, BrushForm::tr("Number"), {-10.0, 10.0, 0.1, 1, {}, false}, 1.0,
             [](BrushSettings& s) -> float& { return s.event.payload; });
    form.addNote(BrushForm::tr("People under the brush hear the event while it plays. Rules say "
                               "what they do then; the number can be a walking speed."));
}

void addPlaces(BrushForm& form, BrushKind kind)
{
    addFloat(form, BrushForm::tr("Radius"), {0.1, 50.0, 0.25, 2, BrushForm::tr(" m"), true}, 1.0,
             [](BrushSettings& s) -> float& { return s.place.radiusMetres; });
    if (kind == BrushKind::Environment) {
        form.addChoice(
            BrushForm::tr("What"),
            {BrushForm::tr("Place to go to"), BrushForm::tr("Obstacle"),
             BrushForm::tr("Attracts people"), BrushForm::tr("Repels people"),
             BrushForm::tr("Exit: people leave"), BrushForm::tr("Slow ground"),
             BrushForm::tr("Nobody walks there"), BrushForm::tr("Liked ground")},
            [](const BrushSettings& s) { return static_cast<int>(s.place.role); },
            [](BrushSettings& s, int i) { s.place.role = static_cast<model::PlaceRole>(i); });
    }
    if (kind == BrushKind::Path) {
        form.addChoice(
            BrushForm::tr("At the end"),
            {BrushForm::tr("Stop"), BrushForm::tr("On to the first place"),
             BrushForm::tr("Jump to the first place")},
            [](const BrushSettings& s) { return static_cast<int>(s.place.kind); },
            [](BrushSettings& s, int i) { s.place.kind = static_cast<model::PathKind>(i); });
        form.addNote(BrushForm::tr("Each click adds a place, Enter ends the path. The next click "
                                   "begins another one."));
    }
}

} // namespace

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
