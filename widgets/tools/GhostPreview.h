// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/brush/BrushSettings.h"
#include "widgets/tools/Tool.h"

namespace crowd::widgets {

/// One of these people; without an asset where his template's file is not there.
[[nodiscard]] render::Ghost ghostOf(const model::Scene& scene,
                                    std::span<const model::WorldSeat> seats,
                                    const model::Population& people, std::size_t row,
                                    double seconds);

/// Who would appear if the button went down here: translucent, with the same looks as then.
[[nodiscard]] std::vector<render::Ghost> ghostsAt(const ToolContext& context,
                                                  const model::BrushSettings& settings,
                                                  std::uint64_t seed, const ToolInput& at);

} // namespace crowd::widgets
