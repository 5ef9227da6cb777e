// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QPointF>

#include "model/brush/BrushSettings.h"
#include "widgets/tools/Tool.h"

namespace crowd::widgets {

/// Whether a brush of this kind works on people who are there.
[[nodiscard]] bool worksOnPeople(model::BrushKind kind);

/// On whom a dab here would work, or may where it takes some at random: a point on each where he is
/// seen, logical pixels. Of very many, evenly so many that they can still be told apart.
[[nodiscard]] std::vector<QPointF>
candidatesAt(const ToolContext& context, const model::BrushSettings& settings, const ToolInput& at);

} // namespace crowd::widgets
