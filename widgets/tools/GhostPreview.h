// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "model/brush/BrushSettings.h"
#include "widgets/tools/Tool.h"

namespace crowd::widgets {

/// Who would appear if the button went down here: translucent, with the same looks as then.
[[nodiscard]] std::vector<render::Ghost> ghostsAt(const ToolContext& context,
                                                  const model::BrushSettings& settings,
                                                  std::uint64_t seed, const ToolInput& at);

} // namespace crowd::widgets
