// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "model/bake/KeyframeStore.h"

namespace crowd::model {

/// Samples the first `keyframes` keyframes of a clip (all: Clip::keyframeCount()), skins every
/// level and packs the result. Pure: the same bits on every thread. Asks `isCancelled` between
/// keyframes and returns null once it says yes.
[[nodiscard]] BakedClipPtr bakeClip(const Template& asset, int clipIndex, int keyframes,
                                    const std::function<bool()>& isCancelled = {});

/// What baking the whole clip will take, in bytes.
[[nodiscard]] std::size_t bakedBytes(const Template& asset, int clipIndex);

/// The finest level at one keyframe before it is packed: template frame, metres, the file's
/// vertices in the file's order.
struct ExactKeyframe
{
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; ///< unit vectors
};
[[nodiscard]] ExactKeyframe exactKeyframe(const Template& asset, int clipIndex, int keyframe);

} // namespace crowd::model
