// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "model/brush/BrushSettings.h"
#include "model/scene/Scene.h"

namespace crowd::app {

/// Whether a brush as a script sets it can paint on this scene: finite numbers within the editor's
/// own limits, templates that are there. The message names the setting and what would do.
[[nodiscard]] model::Result<void> checkBrush(const model::Scene& scene,
                                             const model::BrushSettings& brush);

} // namespace crowd::app
