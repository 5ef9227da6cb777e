// SPDX-License-Identifier: MIT
#pragma once

#include "model/brush/BrushSettings.h"

namespace crowd::model {

/// The settings of a brush of features, whichever kind it has at hand; null: another brush's.
[[nodiscard]] inline const FeatureSettings* featureSettings(const BrushSettings& brush)
{
    const auto* outfit = brush.find<OutfitSettings>();
    return outfit != nullptr ? outfit : brush.find<FeatureSettings>();
}

[[nodiscard]] inline FeatureSettings* featureSettings(BrushSettings& brush)
{
    auto* outfit = brush.find<OutfitSettings>();
    return outfit != nullptr ? outfit : brush.find<FeatureSettings>();
}

} // namespace crowd::model
