// SPDX-License-Identifier: MIT
#include <algorithm>

#include "model/brush/BrushSettings.h"
#include "model/brush/SlotChoice.h"
#include "model/brush/TakenFrom.h"
#include "model/scene/Scene.h"

namespace crowd::model {

namespace {

bool isAmong(const std::vector<int>& chosen, int number)
{
    return chosen.empty() || std::ranges::find(chosen, number) != chosen.end();
}

/// Whether any template of the scene has something of the kind.
template<class Has>
bool anyTemplate(const FieldContext& context, const Has& has)
{
    return context.scene != nullptr &&
           std::ranges::any_of(context.scene->templates, [&](const TemplateEntry& entry) {
               return entry.asset && has(*entry.asset);
           });
}

} // namespace

bool SeatGridSettings::allows(int rank, int wedge) const
{
    return isAmong(ranks, rank) && isAmong(wedges, wedge);
}

bool hasSeats(const FieldContext& context)
{
    return context.scene != nullptr &&
           std::ranges::any_of(context.scene->stages, [](const StageEntry& entry) {
               return entry.asset && !entry.asset->seats.empty();
           });
}

bool createsOnSeats(const FieldContext& context)
{
    const CreateSettings* create =
        context.brush != nullptr ? context.brush->find<CreateSettings>() : nullptr;
    return create != nullptr && create->seats.isOn && hasSeats(context);
}

bool hasOutfits(const FieldContext& context)
{
    return anyTemplate(context, [](const Template& asset) {
        return std::ranges::any_of(asset.slots,
                                   [](const Slot& slot) { return slot.choices.size() > 1; });
    });
}

bool hasFaces(const FieldContext& context)
{
    return anyTemplate(context, [](const Template& asset) {
        return std::ranges::any_of(asset.slots, [](const Slot& slot) {
            return slot.choices.size() > 1 && isOfTheBody(slot.name);
        });
    });
}

bool hasParts(const FieldContext& context)
{
    return anyTemplate(context, [](const Template& asset) { return !asset.parts.empty(); });
}

void CreateSettings::prepare(BrushSettings& brush)
{
    auto& create = brush.as<CreateSettings>();
    create.variesFaces = true;
    create.anywhere = false;
    // Clothes of an ordinary evening: nobody like his neighbour, nobody glaring.
    create.palette = {{42, 52, 86},   {112, 40, 48},   {58, 84, 66},   {196, 186, 168},
                      {70, 70, 76},   {150, 112, 70},  {92, 120, 156}, {206, 160, 72},
                      {120, 84, 122}, {226, 222, 214}, {36, 38, 42},   {168, 92, 66}};
}

MainNumber CreateSettings::mainNumber(const BrushSettings& brush)
{
    const auto& create = brush.as<CreateSettings>();
    if (!brush.takesShare()) {
        return rateOf(brush);
    }
    if (create.seats.isOn) {
        return {QT_TRANSLATE_NOOP("BrushTexts", "Seats filled, %"),
                QT_TRANSLATE_NOOP("BrushTexts", "Seats filled: %1 %"),
                create.seatPercent,
                0.0,
                100.0,
                5.0,
                0};
    }
    if (brush.selection == BrushSelection::Point) {
        return {QT_TRANSLATE_NOOP("BrushTexts", "Distance, m"),
                QT_TRANSLATE_NOOP("BrushTexts", "Distance: %1 m"),
                create.minimalDistance,
                0.1,
                10.0,
                0.1,
                2};
    }
    return {QT_TRANSLATE_NOOP("BrushTexts", "Characters per m²"),
            QT_TRANSLATE_NOOP("BrushTexts", "Density: %1 characters per m²"),
            create.density,
            0.05,
            6.0,
            0.25,
            2};
}

void CreateSettings::setMainNumber(BrushSettings& brush, float value)
{
    auto& create = brush.as<CreateSettings>();
    if (!brush.takesShare()) {
        brush.ratePerSecond = value;
    } else if (create.seats.isOn) {
        create.seatPercent = value;
    } else if (brush.selection == BrushSelection::Point) {
        create.minimalDistance = value;
    } else {
        create.density = value;
    }
}

std::string CreateSettings::take(BrushSettings& brush, const TakenFrom& from)
{
    brush.as<CreateSettings>().mix = {{from.entry.id, 1.0F}};
    return from.entry.name;
}

} // namespace crowd::model
