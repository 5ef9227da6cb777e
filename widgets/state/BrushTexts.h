// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>
#include <QtGui/QColor>

#include "model/scene/Scene.h"
#include "widgets/state/ToolId.h"

/// Names of tools, brush settings and what they paint in the artist's language.
namespace crowd::widgets {

[[nodiscard]] QString toolName(ToolId id);
[[nodiscard]] QString selectionName(model::BrushSelection selection);
[[nodiscard]] QString mainNumberName(const model::MainNumber& number);
/// A text of a description: label, tip, unit, section.
[[nodiscard]] QString fieldText(const char* text);
/// "Brush size: 40 px", or the radius of the places that it paints.
[[nodiscard]] QString brushSizeText(const model::BrushSettings& settings);
/// The main number with its unit: "Density: 1.5 people per m²".
[[nodiscard]] QString mainNumberText(const model::BrushSettings& settings);
/// What a place is, as forms, trees and the history say it: "Forbidden ground".
[[nodiscard]] QString placeRoleName(model::PlaceRole role);
[[nodiscard]] QStringList placeRoleNames(); ///< by PlaceRole
/// What it does to people: "Nobody walks there".
[[nodiscard]] QString placeRoleTip(model::PlaceRole role);
/// As the artist set it, else one of a circle of hues.
[[nodiscard]] QColor tagColor(const model::Scene& scene, int bit);
/// Its name, else its number as artists count.
[[nodiscard]] QString tagText(const model::Scene& scene, int bit);

} // namespace crowd::widgets
