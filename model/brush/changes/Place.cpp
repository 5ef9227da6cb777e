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

} // namespace crowd::model
