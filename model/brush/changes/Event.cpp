// SPDX-License-Identifier: MIT
#include "model/brush/BrushSettings.h"

namespace crowd::model {

MainNumber EventSettings::mainNumber(const BrushSettings& brush)
{
    return {QT_TRANSLATE_NOOP("BrushTexts", "Number"),
            QT_TRANSLATE_NOOP("BrushTexts", "Number: %1"),
            brush.as<EventSettings>().payload,
            -1000.0,
            1000.0,
            0.1,
            1};
}

void EventSettings::setMainNumber(BrushSettings& brush, float value)
{
    brush.as<EventSettings>().payload = value;
}

} // namespace crowd::model
