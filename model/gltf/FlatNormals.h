// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "model/template/Template.h"

namespace crowd::model::gltf {

/// A run of mesh.indices whose vertices came without normals.
struct FlatRun
{
    std::size_t firstIndex = 0;
    std::size_t endIndex = 0;
    bool isMirrored = false; ///< corners were turned over for a mirroring node
};

/// Gives the vertices of the runs the normals of their triangles (glTF 2.0, section 3.7.2.1: flat
/// shading where the file has none). A vertex that lies on differently inclined triangles is copied
/// for each further normal; the copies go behind all vertices of the file.
void computeFlatNormals(Mesh& mesh, const std::vector<FlatRun>& runs);

} // namespace crowd::model::gltf
