// SPDX-License-Identifier: MIT
#include <algorithm>

#include "model/brush/SlotChoice.h"
#include "widgets/docks/BrushFormParts.h"

namespace crowd::widgets {

namespace {

using model::BrushOperator;
using model::BrushSelection;
using model::BrushSettings;
using model::HeadingSettings;
using model::ValueRange;

bool isArea(const BrushSettings& s)
{
    return s.selection == BrushSelection::AllInCircle || s.selection == BrushSelection::Rectangle;
}

void addSeats(BrushForm& form, const BrushForm::Condition& onSeats)
{
    form.addNumberLists(
        {{BrushForm::tr("Rows"), BrushForm::tr("Rows counted from the front, as 1, 3-5"),
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
    const bool hasFaces = anyTemplate(state, [](const model::Template& asset) {
        return std::ranges::any_of(asset.slots, [](const auto& slot) {
            return slot.choices.size() > 1 && model::isOfTheBody(slot.name);
        });
    });
    const bool hasParts =
        anyTemplate(state, [](const model::Template& asset) { return !asset.parts.empty(); });
    form.beginRow();
    addFlag(
        form, BrushForm::tr("Outfits"),
        BrushForm::tr("Each wears any of the clothes that the template has"),
        [](BrushSettings& s) -> bool& { return s.create.variesOutfit; },
        [hasOutfits](const BrushSettings&) { return hasOutfits; });
    addFlag(
        form, BrushForm::tr("Faces"),
        BrushForm::tr("Each has any of the skins, faces and hair that the template has"),
        [](BrushSettings& s) -> bool& {
            s.create.variesFaces = s.create.variesFaces.value_or(s.create.variesOutfit);
            return *s.create.variesFaces;
        },
        [hasFaces](const BrushSettings&) { return hasFaces; });
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

} // namespace

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
        BrushForm::tr("Seat grid: characters sit down where they may"),
        [](BrushSettings& s) -> bool& { return s.create.seats.isOn; },
        [hasSeats](const BrushSettings&) { return hasSeats; });
    addSeats(form, onSeats);
    addFlag(
        form, BrushForm::tr("Anywhere"),
        BrushForm::tr("Also on roofs, trees and wherever else nobody can walk to"),
        [](BrushSettings& s) -> bool& { return s.create.anywhere; }, onGround);
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

} // namespace crowd::widgets
