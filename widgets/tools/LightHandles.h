// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtCore/QPointF>

#include "widgets/tools/Tool.h"

/// Lights as something to take hold of in the picture, while one of them is chosen.
namespace crowd::widgets {

/// What of a light is under the pointer.
struct LightHit
{
    model::LightId light = 0;
    bool isTarget = false; ///< what it shines on; else the lamp
};

/// The chosen light's target or the lamp of any; nothing while none is chosen.
[[nodiscard]] std::optional<LightHit> lightAt(const ToolContext& context, const QPointF& pixel);
/// Press on a light: a click chooses it, a drag moves its lamp at the height at which it hangs
/// (with Shift up and down), or its target over what is under the pointer (with Ctrl
/// onto somebody, with whom it goes then): one undo step.
[[nodiscard]] DragSessionPtr lightDrag(const ToolContext& context, const ToolInput& press,
                                       const LightHit& hit);

} // namespace crowd::widgets
