// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QStringList>
#include <QtGui/QIcon>

#include "model/project/BrushPreset.h"
#include "widgets/state/EditorState.h"

/// What one does with a kept brush, wherever it is offered.
namespace crowd::widgets {

inline constexpr int kMostLatestPresets = 6;

/// Takes the brush up, set like that.
void usePreset(EditorState& state, const model::BrushPreset& preset);
/// Names of those that were taken up, the last one first, over restarts; some may be gone.
[[nodiscard]] QStringList latestPresets();
/// What it paints: the brush's symbol over the colours that it is set to.
[[nodiscard]] QIcon presetPicture(const model::BrushPreset& preset);

} // namespace crowd::widgets
