// SPDX-License-Identifier: MIT
#include "model/bake/ClipBaker.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "model/bake/Octahedral.h"
#include "model/bake/Pose.h"
#include "model/bake/Skinning.h"

namespace crowd::model {

namespace {

constexpr float kSteps = 65535.0F;

std::size_t verticesOfAllLevels(const Template& asset)
{
    std::size_t vertices = 0;
    for (const Mesh& mesh : asset.levels) {
        vertices += mesh.positions.size();
    }
    return vertices;
}

/// Keyframes of one level at full precision, before the clip's box is known.
struct UnpackedLevel
{
    std::vector<glm::vec3> positions; ///< keyframes × V
    std::vector<std::uint16_t> normals;
};

/// With room for all that will come: what grows is copied again and again, and takes fresh pages of
/// the system each time.
std::vector<UnpackedLevel> unpackedLevels(const Template& asset, std::size_t keyframes)
{
    std::vector<UnpackedLevel> levels(asset.levels.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::size_t places = keyframes * asset.levels[i].positions.size();
        levels[i].positions.reserve(places);
        levels[i].normals.reserve(places);
    }
    return levels;
}

void appendKeyframe(const Mesh& mesh, std::span<const glm::mat4> bones,
                    std::vector<glm::vec3>& normals, UnpackedLevel& level, Bounds& bounds)
{
    const std::size_t vertices = mesh.positions.size();
    const std::size_t first = level.positions.size();
    level.positions.resize(first + vertices);
    normals.resize(vertices);
    const std::span<glm::vec3> positions(level.positions.data() + first, vertices);
    skin(mesh, bones, positions, normals);
    for (const glm::vec3& position : positions) {
        bounds.addPlace(position);
    }
    for (const glm::vec3& normal : normals) {
        level.normals.push_back(octahedralEncode(normal));
    }
}

std::uint16_t quantise(float value, float low, float size)
{
    const float share = size > 0.0F ? (value - low) / size : 0.0F;
    const float within = share >= 0.0F ? std::min(share, 1.0F) : 0.0F; // 0 for no number
    return static_cast<std::uint16_t>(std::lround(within * kSteps));
}

std::vector<PackedVertex> pack(const UnpackedLevel& level, const Bounds& box)
{
    const glm::vec3 size = box.size();
    std::vector<PackedVertex> packed(level.positions.size());
    for (std::size_t i = 0; i < packed.size(); ++i) {
        const glm::vec3& p = level.positions[i];
        packed[i] = {quantise(p.x, box.low.x, size.x), quantise(p.y, box.low.y, size.y),
                     quantise(p.z, box.low.z, size.z), level.normals[i]};
    }
    return packed;
}

} // namespace

BakedClipPtr bakeClip(const Template& asset, int clipIndex, int keyframes,
                      const std::function<bool()>& isCancelled)
{
    const Clip& clip = asset.clips[static_cast<std::size_t>(clipIndex)];
    assert(keyframes >= 1 && keyframes <= clip.keyframeCount());
    auto baked = std::make_shared<BakedClip>();
    baked->keyframes = keyframes;
    std::vector<UnpackedLevel> levels = unpackedLevels(asset, static_cast<std::size_t>(keyframes));
    std::vector<glm::vec3> normals;
    Pose pose;
    for (int k = 0; k < keyframes; ++k) {
        if (isCancelled && isCancelled()) {
            return nullptr;
        }
        evaluatePose(asset, clipIndex, clip.keyframeSeconds(k), pose);
        Bounds bounds;
        for (std::size_t level = 0; level < levels.size(); ++level) {
            appendKeyframe(asset.levels[level], pose.bones, normals, levels[level], bounds);
        }
        if (bounds.isEmpty()) {
            bounds.add(glm::vec3(0.0F)); // nothing is drawn
        }
        baked->keyframeBounds.push_back(bounds);
        baked->bounds.add(bounds);
    }
    for (const UnpackedLevel& level : levels) {
        baked->levels.push_back(pack(level, baked->bounds));
    }
    return baked;
}

std::size_t bakedBytes(const Template& asset, int clipIndex)
{
    const Clip& clip = asset.clips[static_cast<std::size_t>(clipIndex)];
    const auto keyframes = static_cast<std::size_t>(clip.keyframeCount());
    return sizeof(BakedClip) +
           keyframes * (verticesOfAllLevels(asset) * sizeof(PackedVertex) + sizeof(Bounds));
}

std::size_t BakedClip::bytes() const
{
    std::size_t total = sizeof(BakedClip) + keyframeBounds.size() * sizeof(Bounds);
    for (const std::vector<PackedVertex>& level : levels) {
        total += level.size() * sizeof(PackedVertex);
    }
    return total;
}

glm::vec3 BakedClip::position(int level, int keyframe, std::size_t vertex) const
{
    const std::vector<PackedVertex>& packed = levels[static_cast<std::size_t>(level)];
    const std::size_t vertices = packed.size() / static_cast<std::size_t>(keyframes);
    const PackedVertex& v = packed[static_cast<std::size_t>(keyframe) * vertices + vertex];
    return bounds.low + bounds.size() * (glm::vec3(v.x, v.y, v.z) / kSteps);
}

glm::vec3 BakedClip::normal(int level, int keyframe, std::size_t vertex) const
{
    const std::vector<PackedVertex>& packed = levels[static_cast<std::size_t>(level)];
    const std::size_t vertices = packed.size() / static_cast<std::size_t>(keyframes);
    return octahedralDecode(packed[static_cast<std::size_t>(keyframe) * vertices + vertex].normal);
}

ExactKeyframe exactKeyframe(const Template& asset, int clipIndex, int keyframe)
{
    const Mesh& mesh = asset.levels.front();
    const Clip& clip = asset.clips[static_cast<std::size_t>(clipIndex)];
    Pose pose;
    evaluatePose(asset, clipIndex, clip.keyframeSeconds(keyframe), pose);
    ExactKeyframe exact;
    exact.positions.resize(mesh.positions.size());
    exact.normals.resize(mesh.positions.size());
    skin(mesh, pose.bones, exact.positions, exact.normals);
    if (mesh.fileVertexCount > 0) { // without the copies behind the file's vertices
        exact.positions.resize(mesh.fileVertexCount);
        exact.normals.resize(mesh.fileVertexCount);
    }
    return exact;
}

} // namespace crowd::model
