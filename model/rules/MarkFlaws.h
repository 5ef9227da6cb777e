// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Message.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// Why a mark of the timeline does nothing, or not all that it says, in this scene; empty: it does.
[[nodiscard]] Message flawOf(const Scene& scene, const Mark& mark);

} // namespace crowd::model
