// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/crowd/CrowdGpu.h"
#include "render/crowd/CrowdView.h"
#include "render/passes/PassContext.h"
#include "render/passes/PeopleDrawing.h"

namespace crowd::render {

/// Texels of a shadow map in which people are as tall as the levels' thresholds want.
inline constexpr LevelThresholds kShadowLevels{{90.0F, 45.0F, 22.0F}, 0.0F};

/// Into the shadow map that is bound, whom a light sees.
[[nodiscard]] model::Result<void> drawCasters(const PassContext& context, PeopleDrawing& people,
                                              CrowdGpu& crowd, const CrowdView& seen);

} // namespace crowd::render
