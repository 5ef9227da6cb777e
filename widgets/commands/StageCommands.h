// SPDX-License-Identifier: MIT
#pragma once

#include "model/document/SceneEdit.h"

namespace crowd::widgets {

/// Puts a stage of the scene where `placed` has it, in an open edit. Who has a seat there goes with
/// it. `scene`: as it is before.
void placeStage(model::SceneEdit& edit, const model::Scene& scene, const model::StageEntry& placed);

} // namespace crowd::widgets
