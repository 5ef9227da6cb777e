// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QString>

#include "model/scene/Light.h"
#include "widgets/state/EditorState.h"

/// What panel and picture do with the lights of a scene: one undo step each. World frame, metres.
namespace crowd::widgets {

/// One that lights that point, from where it is seen; it is chosen then. Its id, 0: there are
/// as many as there can be.
model::LightId addLight(EditorState& state, model::LightKind kind, const glm::vec3& lit);
/// A spotlight that goes with somebody, where he is shown now.
model::LightId addFollowSpot(EditorState& state, model::IndividualId person);
void removeLight(EditorState& state, model::LightId id);
void changeLight(EditorState& state, model::LightId id, const QString& undoText,
                 const std::function<void(model::Light&)>& apply);
/// The lights with one of them changed.
[[nodiscard]] model::Lights withLight(const model::Lights& lights, model::LightId id,
                                      const std::function<void(model::Light&)>& apply);

} // namespace crowd::widgets
