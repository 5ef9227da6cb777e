// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "model/base/Message.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// Why a mark of the timeline does nothing, or not all that it says, in this scene; empty: it does.
[[nodiscard]] Message flawOf(const Scene& scene, const Mark& mark);
/// The same of all marks of the scene that have one, also where one keeps another from being seen.
[[nodiscard]] std::map<MarkId, Message> flawsOfMarks(const Scene& scene);

} // namespace crowd::model
