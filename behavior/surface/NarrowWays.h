// SPDX-License-Identifier: MIT
#pragma once

#include <recastnavigation/Recast.h>

namespace crowd::behavior {

/// How near to what stands in the way people get, in cells of the height field.
struct BodyCells
{
    int radius = 1;    ///< where there is room
    int narrowest = 1; ///< where there is not: between seats, through a door; at most `radius`
};

/// Takes from what can be walked on whatever is too near to an edge for bodies: a radius where
/// there is room, less in ways that a whole body would not get through, and where such a way
/// begins. False: out of memory. Any one thread.
///
/// After the opening of mathematical morphology (J. Serra, Image Analysis and Mathematical
/// Morphology, 1982): what is left of the ground of slim bodies once all is taken away that whole
/// bodies cover is narrow.
[[nodiscard]] bool erodeForBodies(rcContext& context, const BodyCells& body,
                                  rcCompactHeightfield& field);

} // namespace crowd::behavior
