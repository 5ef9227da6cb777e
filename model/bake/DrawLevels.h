// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "model/template/Template.h"

namespace crowd::model {

/// What is drawn at one level of detail: triangles over the vertices (and so the keyframes) of an
/// authored level.
struct DrawLevel
{
    int vertexLevel = 0; ///< index into Template::levels
    std::vector<std::uint32_t> indices;
    std::vector<Submesh> submeshes; ///< ranges of `indices`
};

/// One to kMaxLevels levels, finest first. A template that brings levels keeps them; one that
/// brings a single level gets coarser ones by simplifying its triangles over the same vertices, in
/// the pose of its default clip. Levels that would not save a fifth are left out.
[[nodiscard]] std::vector<DrawLevel> drawLevels(const Template& asset);

} // namespace crowd::model
