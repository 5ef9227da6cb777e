// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtCore/QPointF>

#include "model/describe/Field.h"
#include "widgets/tools/Tool.h"

/// Lights as something to take hold of in the picture, while one of them is chosen.
namespace crowd::widgets {

/// What of a light is under the pointer: a field of its description that lies in the scene.
struct LightHit
{
    model::LightId light = 0;
    const model::FieldInfo* field = nullptr;

    [[nodiscard]] bool is(model::FieldRole role) const { return field->meta.role == role; }
};

/// A handle of the chosen light or the lamp of any; nothing while none is chosen.
[[nodiscard]] std::optional<LightHit> lightAt(const ToolContext& context, const QPointF& pixel);
/// Press on a light: a click chooses it, a drag is one undo step. What its field's role is says
/// what it does. Space: it moves at the height at which it is, with Shift up and down. Target: it
/// goes over what is under the pointer; with Ctrl onto somebody, with whom the light goes then.
/// Opening: the cone's edge goes with the pointer.
[[nodiscard]] DragSessionPtr lightDrag(const ToolContext& context, const ToolInput& press,
                                       const LightHit& hit);

} // namespace crowd::widgets
