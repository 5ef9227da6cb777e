// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QtCore/QString>

#include "model/document/SceneDelta.h"
#include "model/scene/Scene.h"

namespace crowd::app {

/// What an edit did, as Python: `with scene.edit("…"):` and everything by id. Run on the scene
/// before, it gives the same bytes and the same next id. `after` is the scene as it is now.
[[nodiscard]] std::string deltaScript(const model::SceneDelta& delta, const QString& undoText,
                                      const model::Scene& after);

} // namespace crowd::app
