// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "model/brush/BrushSettings.h"
#include "model/scene/Scene.h"

namespace crowd::app {

/// Whether a brush as a script sets it can paint: finite numbers within the editor's own limits.
/// The message names the setting and what would do.
[[nodiscard]] model::Result<void> checkBrush(const model::BrushSettings& brush);

/// Whether the scene has what the brush names: templates, groups, paths, clips. In the editor a
/// brush may name what was removed since, and paints without it.
[[nodiscard]] model::Result<void> checkReferences(const model::Scene& scene,
                                                  const model::BrushSettings& brush);

} // namespace crowd::app
