// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "model/document/SceneEdit.h"
#include "model/pick/WalkableGround.h"

namespace crowd::model {

/// Of these people, those who stand where nobody can walk: on roofs, in basins, in the air. Who has
/// a seat is left out.
[[nodiscard]] std::vector<IndividualId> offGround(const Scene& scene, const WalkableGround& ground,
                                                  std::span<const IndividualId> ids);

/// Puts those of them who stand where nobody can walk on the nearest ground, beside whoever stands
/// there. How many.
int putOnGround(SceneEdit& edit, const WalkableGround& ground, std::span<const IndividualId> ids);

} // namespace crowd::model
