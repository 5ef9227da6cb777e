// SPDX-License-Identifier: MIT
#include "widgets/state/BrushTexts.h"

#include <algorithm>

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
        return BrushTextsContext::tr("Characters per m²");
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
        return BrushTextsContext::tr("Density: %1 characters per m²").arg(value);
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

QString placeRoleName(model::PlaceRole role)
{
    switch (role) {
    case model::PlaceRole::Spot:
        return BrushTextsContext::tr("Place");
    case model::PlaceRole::Obstacle:
        return BrushTextsContext::tr("Obstacle");
    case model::PlaceRole::Attractor:
        return BrushTextsContext::tr("Attractor");
    case model::PlaceRole::Repeller:
        return BrushTextsContext::tr("Repeller");
    case model::PlaceRole::Exit:
        return BrushTextsContext::tr("Exit");
    case model::PlaceRole::Slow:
        return BrushTextsContext::tr("Slow ground");
    case model::PlaceRole::Forbidden:
        return BrushTextsContext::tr("Forbidden ground");
    case model::PlaceRole::Preferred:
        return BrushTextsContext::tr("Liked ground");
    }
    return {};
}

QStringList placeRoleNames()
{
    QStringList names;
    for (int role = 0; role <= static_cast<int>(model::PlaceRole::Preferred); ++role) {
        names << placeRoleName(static_cast<model::PlaceRole>(role));
    }
    return names;
}

QString placeRoleTip(model::PlaceRole role)
{
    switch (role) {
    case model::PlaceRole::Spot:
        return BrushTextsContext::tr("Somewhere to go to; does nothing by itself");
    case model::PlaceRole::Obstacle:
        return BrushTextsContext::tr("Nobody walks into it");
    case model::PlaceRole::Attractor:
        return BrushTextsContext::tr("Draws those who walk near it");
    case model::PlaceRole::Repeller:
        return BrushTextsContext::tr("Those who walk near it keep away");
    case model::PlaceRole::Exit:
        return BrushTextsContext::tr("Who reaches it leaves the scene");
    case model::PlaceRole::Slow:
        return BrushTextsContext::tr("Characters walk slower there");
    case model::PlaceRole::Forbidden:
        return BrushTextsContext::tr("Nobody walks there; ways lead around it");
    case model::PlaceRole::Preferred:
        return BrushTextsContext::tr("Ways lead over it where that is not much longer");
    }
    return {};
}

QColor tagColor(const model::Scene& scene, int bit)
{
    const auto named = std::ranges::find(scene.tags, bit, &model::TagName::bit);
    return named != scene.tags.end() ? QColor(named->color[0], named->color[1], named->color[2])
                                     : QColor::fromHsv(bit * 67 % 360, 200, 230);
}

QString tagText(const model::Scene& scene, int bit)
{
    const auto named = std::ranges::find(scene.tags, bit, &model::TagName::bit);
    return named != scene.tags.end() && !named->name.empty()
               ? QString::fromStdString(named->name)
               : BrushTextsContext::tr("Tag %1").arg(bit + 1);
}

} // namespace crowd::widgets
