// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "model/template/Template.h"

namespace crowd::render {

/// A walking figure of ellipsoids with about `triangles` triangles at the finest of four levels,
/// five slots (one of them textured) and clips "walk", "cheer" and "idle", made in code: a workload
/// of any size that needs no file.
[[nodiscard]] std::shared_ptr<model::Template> makeSyntheticPerson(int triangles);

} // namespace crowd::render
