// SPDX-License-Identifier: MIT
#include "model/gltf/BodySize.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "model/bake/Pose.h"
#include "model/bake/Skinning.h"

namespace crowd::model::gltf {

namespace {

constexpr float kOutside = 0.04F;   ///< share of the surface on each side that does not count
constexpr float kUpper = 0.67F;     ///< of the height: arms held out and roofs are above
constexpr float kRoom = 1.1F;       ///< times what it measures: to move in
constexpr float kLong = 1.6F;       ///< times its width: a body that long is no disc
constexpr float kLeastShare = 0.1F; ///< of its half length: thinner than that is no body
constexpr float kUpright = 1.5F;    ///< times its half width: what is higher stands upright
constexpr float kStout = 0.3F;      ///< of the height: the rest is arms and what they carry
/// Times its depth: what is wider than that holds its arms out.
constexpr float kDeep = 2.0F;

/// A part of the surface.
struct Patch
{
    glm::vec3 middle{0.0F};
    float area = 0.0F;
};

std::vector<Patch> patchesOf(const Template& asset)
{
    const Mesh& mesh = asset.levels.front();
    Pose pose;
    evaluatePose(asset, asset.defaultClip, 0.0F, pose);
    std::vector<glm::vec3> at(mesh.positions.size());
    skin(mesh, pose.bones, at, {});
    std::vector<Patch> patches;
    for (const Submesh& submesh : mesh.submeshes) {
        const bool isShown =
            submesh.part < 0 || asset.parts[static_cast<std::size_t>(submesh.part)].shownByDefault;
        for (std::uint32_t i = 0; isShown && i + 2 < submesh.indexCount; i += 3) {
            const std::uint32_t* corner = &mesh.indices[submesh.firstIndex + i];
            const glm::vec3 a = at[corner[0]];
            const glm::vec3 b = at[corner[1]];
            const glm::vec3 c = at[corner[2]];
            const glm::vec3 middle = (a + b + c) / 3.0F;
            const float area = 0.5F * glm::length(glm::cross(b - a, c - a));
            if (Bounds::isPlace(middle) && std::isfinite(area)) {
                patches.push_back({middle, area});
            }
        }
    }
    return patches;
}

/// Where a share of the surface is below.
float quantile(std::vector<Patch>& patches, float glm::vec3::*axis, float share)
{
    std::ranges::sort(patches, [axis](const Patch& a, const Patch& b) {
        return a.middle.*axis < b.middle.*axis;
    });
    double all = 0.0;
    for (const Patch& patch : patches) {
        all += static_cast<double>(patch.area);
    }
    double sum = 0.0;
    for (const Patch& patch : patches) {
        sum += static_cast<double>(patch.area);
        if (sum >= static_cast<double>(share) * all) {
            return patch.middle.*axis;
        }
    }
    return patches.back().middle.*axis;
}

struct Range
{
    float low = 0.0F;
    float high = 0.0F;
    [[nodiscard]] float half() const { return 0.5F * (high - low); }
};

Range rangeOf(std::vector<Patch>& patches, float glm::vec3::*axis)
{
    return {quantile(patches, axis, kOutside), quantile(patches, axis, 1.0F - kOutside)};
}

} // namespace

Footprint footprintOf(const Template& asset)
{
    if (asset.levels.empty() || asset.levels.front().indices.empty() || asset.height <= 0.0F) {
        return {};
    }
    std::vector<Patch> patches = patchesOf(asset);
    if (patches.empty()) {
        return {};
    }
    const Range along = rangeOf(patches, &glm::vec3::z);
    const float top = asset.bounds.low.y + kUpper * asset.height;
    std::vector<Patch> lower = patches;
    std::erase_if(lower, [top](const Patch& patch) { return patch.middle.y > top; });
    const Range across = rangeOf(lower.empty() ? patches : lower, &glm::vec3::x);
    Footprint body;
    if (along.half() > kLong * across.half()) {
        body.radius = kRoom * std::max(across.half(), kLeastShare * along.half());
        body.front = std::max(along.high - body.radius, 0.0F);
        body.back = std::max(-along.low - body.radius, 0.0F);
    } else {
        body.radius = kRoom * std::min(across.half(), kDeep * along.half());
    }
    if (asset.height > kUpright * across.half()) {
        body.radius = std::min(body.radius, kStout * asset.height);
    }
    return body;
}

} // namespace crowd::model::gltf
