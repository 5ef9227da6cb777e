// SPDX-License-Identifier: MIT
#include "model/brush/BrushSettings.h"

namespace crowd::model {

namespace {

constexpr float kLeastByKey = 0.25F; ///< metres: one person stands in it

}

void PlaceSettings::prepare(BrushSettings& brush)
{
    brush.place()->anywhere = false;
    brush.selection = BrushSelection::Point;
}

MainNumber PlaceSettings::mainNumber(const BrushSettings& brush)
{
    return {QT_TRANSLATE_NOOP("BrushTexts", "Radius, m"),
            QT_TRANSLATE_NOOP("BrushTexts", "Radius: %1 m"),
            brush.place()->radiusMetres,
            kLeastByKey,
            kMaxPlaceRadius,
            0.25,
            2};
}

void PlaceSettings::setMainNumber(BrushSettings& brush, float value)
{
    brush.place()->radiusMetres = value;
}

MainNumber EnvironmentSettings::mainNumber(const BrushSettings& brush)
{
    const auto& settings = brush.as<EnvironmentSettings>();
    if (settings.shape != PlaceShape::Line) {
        return PlaceSettings::mainNumber(brush);
    }
    return {QT_TRANSLATE_NOOP("BrushTexts", "Width, m"),
            QT_TRANSLATE_NOOP("BrushTexts", "Width: %1 m"),
            settings.widthMetres,
            2.0F * kMinPlaceRadius,
            2.0F * kMaxPlaceRadius,
            0.1,
            2};
}

void EnvironmentSettings::setMainNumber(BrushSettings& brush, float value)
{
    auto& settings = brush.as<EnvironmentSettings>();
    (settings.shape == PlaceShape::Line ? settings.widthMetres : settings.radiusMetres) = value;
}

} // namespace crowd::model
