// SPDX-License-Identifier: MIT
#pragma once

#include "behavior/session/SessionParts.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// Takes edits of the scene over into a session that runs: what an edit has changed since the last
/// look at the scene is changed here too, everything else goes on as it is. After poses were kept,
/// where people are in the scene is where they are here.
void adoptScene(SessionParts& parts, const model::Scene& scene, bool arePosesKept);

/// The same with other people than the scene's, the same ones: as they are to be in the session.
void adoptPeople(SessionParts& parts, const model::Scene& scene, const model::Population& people,
                 bool arePosesKept);

} // namespace crowd::behavior
