// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include <glm/vec3.hpp>

#include "behavior/surface/SurfacePlan.h"
#include "behavior/surface/WalkSurface.h"
#include "model/scene/Scene.h"

/// Stages of boxes, for tests of where people can walk. World frame, metres.
namespace crowd::testing {

inline void addBox(model::StageMesh& mesh, const glm::vec3& low, const glm::vec3& high)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.emplace_back((corner & 1) != 0 ? high.x : low.x,
                                    (corner & 2) != 0 ? high.y : low.y,
                                    (corner & 4) != 0 ? high.z : low.z);
    }
    // Outwards, counter-clockwise.
    for (const std::uint32_t index :
         {0U, 4U, 6U, 0U, 6U, 2U, 1U, 3U, 7U, 1U, 7U, 5U, 0U, 1U, 5U, 0U, 5U, 4U,
          2U, 6U, 7U, 2U, 7U, 3U, 0U, 2U, 3U, 0U, 3U, 1U, 4U, 5U, 7U, 4U, 7U, 6U}) {
        mesh.indices.push_back(first + index);
    }
}

[[nodiscard]] inline model::StageEntry stageOf(const model::StageMesh& mesh)
{
    auto asset = std::make_shared<model::StageAsset>();
    asset->meshes = {mesh};
    asset->materials.emplace_back();
    for (const glm::vec3& position : mesh.positions) {
        asset->bounds.add(position);
    }
    model::StageEntry entry;
    entry.id = 1;
    entry.asset = asset;
    return entry;
}

/// Null where the scene has none.
[[nodiscard]] inline std::shared_ptr<const behavior::WalkSurface>
surfaceOf(const model::Scene& scene)
{
    behavior::WalkSurface::Progress progress;
    auto built = behavior::WalkSurface::build(behavior::SurfacePlan::of(scene), progress);
    return built ? built.value() : nullptr;
}

} // namespace crowd::testing
