// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "widgets/state/ToolId.h"

/// Names of tools and brush settings in the artist's language.
namespace crowd::widgets {

[[nodiscard]] QString toolName(ToolId id);
[[nodiscard]] QString selectionName(model::BrushSelection selection);
[[nodiscard]] QString mainQuantityName(model::MainQuantity quantity);
/// "Brush size: 40 px", or the radius of the places that it paints.
[[nodiscard]] QString brushSizeText(const model::BrushSettings& settings);
/// The main number with its unit: "Density: 1.5 people per m²".
[[nodiscard]] QString mainNumberText(const model::BrushSettings& settings);

} // namespace crowd::widgets
