// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "model/document/SceneEdit.h"

/// Edits of places and paths that are more than one step of a SceneEdit. All keep paths sound: they
/// name only places that are there.
namespace crowd::model {

/// A new place at the end of a path, or of a new path of the kind given where `path` is 0 or gone.
/// Returns the path.
PathId appendPlace(SceneEdit& edit, PathId path, Place place, PathKind kind);
/// A place that is there already, at the end of a path, or of a new one. Returns the path.
PathId appendKnownPlace(SceneEdit& edit, PathId path, PlaceId place, PathKind kind);
/// A new place between two of a path, before the one at `index`.
PlaceId insertPlace(SceneEdit& edit, PathId path, std::size_t index, Place place);
/// A new path over places that are there.
PathId addPathOver(SceneEdit& edit, std::span<const PlaceId> places, PathKind kind);
void reversePath(SceneEdit& edit, PathId path);
/// The places of `second` go to the end of `first`; who walked the second one walks the first.
void joinPaths(SceneEdit& edit, PathId first, PathId second);
/// A colour for the next path, unlike those before it.
[[nodiscard]] std::array<std::uint8_t, 3> colorOfPath(PathId id);

} // namespace crowd::model
