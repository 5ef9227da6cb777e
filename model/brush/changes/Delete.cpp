// SPDX-License-Identifier: MIT
#include "model/brush/BrushSettings.h"

namespace crowd::model {

void DeleteSettings::prepare(BrushSettings& brush)
{
    brush.selection = BrushSelection::AllInCircle;
    brush.radiusPixels = 24.0F;
}

MainNumber DeleteSettings::mainNumber(const BrushSettings& brush)
{
    if (!brush.takesShare()) {
        return rateOf(brush);
    }
    return {QT_TRANSLATE_NOOP("BrushTexts", "Of them, %"),
            QT_TRANSLATE_NOOP("BrushTexts", "Delete: %1 % of them"),
            brush.as<DeleteSettings>().percent,
            5.0,
            100.0,
            5.0,
            0};
}

void DeleteSettings::setMainNumber(BrushSettings& brush, float value)
{
    (brush.takesShare() ? brush.as<DeleteSettings>().percent : brush.ratePerSecond) = value;
}

} // namespace crowd::model
