// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/PlaceHits.h"

/// Places as something to take hold of in the picture.
namespace crowd::widgets {

/// The path on whose band the ground under a pixel lies; of several, the one whose middle is
/// nearest for its width. 0: none, or paths are not shown.
[[nodiscard]] model::PathId pathUnder(const ToolContext& context, const ToolInput& input);
/// A place into the path under the pointer, where it is; it is what is selected then. False: there
/// is no path.
bool insertPlaceUnder(const ToolContext& context, const ToolInput& input);
/// Press on a place: a click selects (Shift adds), a drag moves it with the others selected, or
/// changes its size.
[[nodiscard]] DragSessionPtr placeDrag(const ToolContext& context, const ToolInput& press,
                                       const PlaceHit& hit);

/// The selected places become larger or smaller, in the steps of the path brush: one undo step.
void resizePlaces(EditorState& state, int steps);
/// The next place begins another path, the next corner another line or area. A path of a single
/// place leads nowhere: it goes, with its place unless something else needs that; so does a single
/// corner.
void endPath(EditorState& state);
/// A path of a kind over the selected places, which is the current one from then on.
void makePathOfPlaces(EditorState& state, model::PathKind kind);

} // namespace crowd::widgets
