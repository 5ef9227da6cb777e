// SPDX-License-Identifier: MIT
#include "widgets/state/BrushTexts.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

namespace crowd::widgets {

using model::BrushSelection;
using model::MainQuantity;

namespace {

struct BrushTextsContext
{
    Q_DECLARE_TR_FUNCTIONS(BrushTexts)
};

} // namespace

QString toolName(ToolId id)
{
    return QCoreApplication::translate("Tools", toolInfo(id).name);
}

QString selectionName(BrushSelection selection)
{
    switch (selection) {
    case BrushSelection::Point:
        return BrushTextsContext::tr("Point");
    case BrushSelection::Spray:
        return BrushTextsContext::tr("Spray");
    case BrushSelection::AllInCircle:
        return BrushTextsContext::tr("All in the circle");
    case BrushSelection::Rectangle:
        return BrushTextsContext::tr("Rectangle");
    }
    return {};
}

QString mainQuantityName(MainQuantity quantity)
{
    switch (quantity) {
    case MainQuantity::Density:
        return BrushTextsContext::tr("People per m²");
    case MainQuantity::SeatPercent:
        return BrushTextsContext::tr("Seats filled, %");
    case MainQuantity::Distance:
        return BrushTextsContext::tr("Distance, m");
    case MainQuantity::Rate:
        return BrushTextsContext::tr("Rate, a second");
    case MainQuantity::DeletePercent:
        return BrushTextsContext::tr("Of them, %");
    case MainQuantity::Strength:
        return BrushTextsContext::tr("Strength, %");
    case MainQuantity::Heading:
        return BrushTextsContext::tr("Direction, °");
    case MainQuantity::Turn:
        return BrushTextsContext::tr("Turned by, °");
    case MainQuantity::Speed:
        return BrushTextsContext::tr("Speed");
    case MainQuantity::WalkSpeed:
        return BrushTextsContext::tr("Walking speed, m/s");
    case MainQuantity::Tag:
        return BrushTextsContext::tr("Tag");
    case MainQuantity::Payload:
        return BrushTextsContext::tr("Number");
    case MainQuantity::PlaceRadius:
        return BrushTextsContext::tr("Radius, m");
    }
    return {};
}

QString mainNumberText(const model::BrushSettings& settings)
{
    const model::MainNumber number = settings.mainNumber();
    const QString value = QLocale().toString(number.value, 'f', number.decimals);
    switch (number.quantity) {
    case MainQuantity::Density:
        return BrushTextsContext::tr("Density: %1 people per m²").arg(value);
    case MainQuantity::SeatPercent:
        return BrushTextsContext::tr("Seats filled: %1 %").arg(value);
    case MainQuantity::Distance:
        return BrushTextsContext::tr("Distance: %1 m").arg(value);
    case MainQuantity::Rate:
        return BrushTextsContext::tr("Rate: %1 a second").arg(value);
    case MainQuantity::DeletePercent:
        return BrushTextsContext::tr("Delete: %1 % of them").arg(value);
    case MainQuantity::Strength:
        return BrushTextsContext::tr("Strength: %1 %").arg(value);
    case MainQuantity::Heading:
        return BrushTextsContext::tr("Direction: %1°").arg(value);
    case MainQuantity::Turn:
        return BrushTextsContext::tr("Turned by: %1°").arg(value);
    case MainQuantity::Speed:
        return BrushTextsContext::tr("Speed: × %1").arg(value);
    case MainQuantity::WalkSpeed:
        return BrushTextsContext::tr("Walking speed: %1 m/s").arg(value);
    case MainQuantity::Tag:
        return BrushTextsContext::tr("Tag: %1").arg(value);
    case MainQuantity::Payload:
        return BrushTextsContext::tr("Number: %1").arg(value);
    case MainQuantity::PlaceRadius:
        return BrushTextsContext::tr("Radius: %1 m").arg(value);
    }
    return value;
}

QString brushSizeText(const model::BrushSettings& settings)
{
    return settings.addsPlaces()
               ? mainNumberText(settings)
               : QCoreApplication::translate("crowd::widgets::ToolController", "Brush size: %1 px")
                     .arg(qRound(settings.radiusPixels));
}

} // namespace crowd::widgets
