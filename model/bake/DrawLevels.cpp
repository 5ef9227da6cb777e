// SPDX-License-Identifier: MIT
#include "model/bake/DrawLevels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <meshoptimizer.h>

#include "model/bake/Pose.h"
#include "model/bake/Skinning.h"

namespace crowd::model {

namespace {

/// Triangles of the generated levels as a share of the finest: those of the built-in people.
constexpr std::array<float, kMaxLevels - 1> kShares{0.45F, 0.25F, 0.12F};
constexpr float kMaxError = 0.08F; ///< of the submesh's extent
constexpr float kWorthwhile = 0.8F;
constexpr std::size_t kSmallestMesh = 64; ///< triangles; below it nothing is generated

/// Where all vertices are that indices may name, the copies for flat normals among them. What is
/// nowhere, or too far away to reckon with, is put into the middle.
std::vector<glm::vec3> posedPositions(const Template& asset)
{
    const Mesh& mesh = asset.levels.front();
    Pose pose;
    evaluatePose(asset, asset.defaultClip, 0.0F, pose);
    std::vector<glm::vec3> positions(mesh.positions.size());
    skin(mesh, pose.bones, positions, {});
    for (glm::vec3& position : positions) {
        if (!Bounds::isPlace(position)) {
            position = glm::vec3(0.0F);
        }
    }
    return positions;
}

/// Whole triangles over vertices that are there: meshoptimizer asserts what it is not given so.
bool isSound(const DrawLevel& level, std::size_t vertices)
{
    const bool hasVertices = std::ranges::all_of(
        level.indices, [vertices](std::uint32_t index) { return index < vertices; });
    return hasVertices && std::ranges::all_of(level.submeshes, [&](const Submesh& submesh) {
               return submesh.indexCount % 3 == 0 && submesh.firstIndex <= level.indices.size() &&
                      submesh.indexCount <= level.indices.size() - submesh.firstIndex;
           });
}

std::size_t simplify(const std::vector<glm::vec3>& positions, const std::uint32_t* indices,
                     std::size_t count, std::size_t target, std::vector<std::uint32_t>& out)
{
    const float* data = &positions[0].x;
    std::size_t made = meshopt_simplify(out.data(), indices, count, data, positions.size(),
                                        sizeof(glm::vec3), target, kMaxError);
    // Hard edges everywhere (flat shading) lock every vertex: clustering still helps there.
    if (made > target + target / 2) {
        made = meshopt_simplifySloppy(out.data(), indices, count, data, positions.size(),
                                      sizeof(glm::vec3), target, kMaxError);
    }
    return made;
}

DrawLevel simplified(const DrawLevel& finest, const std::vector<glm::vec3>& positions, float share)
{
    DrawLevel level;
    level.vertexLevel = finest.vertexLevel;
    std::vector<std::uint32_t> scratch;
    for (Submesh submesh : finest.submeshes) {
        const std::uint32_t* source = finest.indices.data() + submesh.firstIndex;
        const std::uint32_t all = submesh.indexCount / 3;
        const auto triangles = std::lround(static_cast<float>(all) * share);
        const std::size_t target = std::min<std::size_t>(
            static_cast<std::size_t>(std::max(triangles, 2L)) * 3, submesh.indexCount);
        scratch.resize(submesh.indexCount);
        const std::size_t made = simplify(positions, source, submesh.indexCount, target, scratch);
        submesh.firstIndex = static_cast<std::uint32_t>(level.indices.size());
        submesh.indexCount = static_cast<std::uint32_t>(made);
        level.indices.insert(level.indices.end(), scratch.begin(),
                             scratch.begin() + static_cast<std::ptrdiff_t>(made));
        if (made > 0) {
            level.submeshes.push_back(submesh);
        }
    }
    return level;
}

bool isWorthwhile(const DrawLevel& coarser, const DrawLevel& finer)
{
    return !coarser.indices.empty() && static_cast<float>(coarser.indices.size()) <
                                           kWorthwhile * static_cast<float>(finer.indices.size());
}

} // namespace

std::vector<DrawLevel> drawLevels(const Template& asset)
{
    std::vector<DrawLevel> levels;
    for (std::size_t i = 0; i < asset.levels.size(); ++i) {
        const Mesh& mesh = asset.levels[i];
        levels.push_back({static_cast<int>(i), mesh.indices, mesh.submeshes});
    }
    if (levels.size() != 1 || levels[0].indices.size() / 3 < kSmallestMesh) {
        return levels;
    }
    const std::vector<glm::vec3> positions = posedPositions(asset);
    if (!isSound(levels.front(), positions.size())) {
        return levels;
    }
    for (const float share : kShares) {
        DrawLevel coarser = simplified(levels.front(), positions, share);
        if (isWorthwhile(coarser, levels.back())) {
            levels.push_back(std::move(coarser));
        }
    }
    return levels;
}

} // namespace crowd::model
