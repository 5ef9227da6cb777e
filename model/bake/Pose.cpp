// SPDX-License-Identifier: MIT
#include "model/bake/Pose.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace crowd::model {

namespace {

/// Between which keys of a channel a moment lies.
struct KeySpan
{
    std::size_t left = 0;
    std::size_t right = 0;
    float fraction = 0.0F; ///< 0 at left, 1 at right
    float width = 0.0F;    ///< seconds between the keys
};

KeySpan keySpan(const std::vector<float>& times, float at)
{
    const auto after = std::upper_bound(times.begin(), times.end(), at);
    if (after == times.begin()) {
        return {};
    }
    KeySpan span;
    span.right = static_cast<std::size_t>(after - times.begin());
    span.left = span.right - 1;
    if (span.right == times.size()) {
        span.right = span.left;
        return span;
    }
    span.width = times[span.right] - times[span.left];
    span.fraction = span.width > 0.0F ? (at - times[span.left]) / span.width : 0.0F;
    return span;
}

glm::vec4 read(const float* values, int components)
{
    return {values[0], values[1], values[2], components == 4 ? values[3] : 0.0F};
}

glm::quat asQuaternion(const glm::vec4& v)
{
    return {v.w, v.x, v.y, v.z};
}

/// Shoemake 1985; falls back to a normalised blend where the angle is too small for the sine.
glm::vec4 slerp(const glm::vec4& from, glm::vec4 to, float fraction)
{
    float cosine = glm::dot(from, to);
    if (cosine < 0.0F) {
        to = -to;
        cosine = -cosine;
    }
    if (cosine > 0.9995F) {
        return glm::normalize(from + (to - from) * fraction);
    }
    const float angle = std::acos(std::min(cosine, 1.0F));
    const float sine = std::sin(angle);
    return from * (std::sin((1.0F - fraction) * angle) / sine) +
           to * (std::sin(fraction * angle) / sine);
}

/// glTF 2.0, appendix C.5: Hermite basis, tangents scaled by the width of the span.
glm::vec4 cubic(const float* left, const float* right, int components, const KeySpan& span)
{
    const float t = span.fraction;
    const float t2 = t * t;
    const float t3 = t2 * t;
    const glm::vec4 valueLeft = read(left + components, components);
    const glm::vec4 tangentLeft = read(left + std::ptrdiff_t{2} * components, components);
    const glm::vec4 tangentRight = read(right, components);
    const glm::vec4 valueRight = read(right + components, components);
    return valueLeft * (2.0F * t3 - 3.0F * t2 + 1.0F) +
           tangentLeft * (span.width * (t3 - 2.0F * t2 + t)) +
           valueRight * (-2.0F * t3 + 3.0F * t2) + tangentRight * (span.width * (t3 - t2));
}

glm::vec4 sample(const Channel& channel, float at)
{
    const int components = channel.path == ChannelPath::Rotation ? 4 : 3;
    const bool isCubic = channel.interpolation == Interpolation::CubicSpline;
    const std::size_t stride = static_cast<std::size_t>(components) * (isCubic ? 3 : 1);
    const KeySpan span = keySpan(channel.times, at);
    const float* left = channel.values.data() + span.left * stride;
    const float* right = channel.values.data() + span.right * stride;
    if (isCubic) {
        return span.left == span.right ? read(left + components, components)
                                       : cubic(left, right, components, span);
    }
    if (channel.interpolation == Interpolation::Step || span.left == span.right) {
        return read(left, components);
    }
    const glm::vec4 from = read(left, components);
    const glm::vec4 to = read(right, components);
    if (channel.path == ChannelPath::Rotation) {
        return slerp(from, to, span.fraction);
    }
    return from + (to - from) * span.fraction;
}

void apply(const Channel& channel, float at, Pose::Local& local)
{
    const glm::vec4 value = sample(channel, at);
    local.isMatrix = false;
    switch (channel.path) {
    case ChannelPath::Translation:
        local.translation = value;
        break;
    case ChannelPath::Rotation:
        local.rotation = glm::normalize(asQuaternion(value));
        break;
    case ChannelPath::Scale:
        local.scale = value;
        break;
    }
}

glm::mat4 matrixOf(const Pose::Local& local)
{
    glm::mat4 matrix = glm::mat4_cast(local.rotation);
    matrix[0] *= local.scale.x;
    matrix[1] *= local.scale.y;
    matrix[2] *= local.scale.z;
    matrix[3] = glm::vec4(local.translation, 1.0F);
    return matrix;
}

void resetToRest(const Template& asset, Pose& pose)
{
    pose.locals.resize(asset.nodes.size());
    pose.nodeWorld.resize(asset.nodes.size());
    pose.bones.resize(asset.bones.size());
    for (std::size_t i = 0; i < asset.nodes.size(); ++i) {
        const Node& node = asset.nodes[i];
        pose.locals[i] = {node.translation, node.rotation, node.scale, node.matrix.has_value()};
    }
}

/// `shift` is taken from the world of the clip's root motion node, and so from all below it.
void chainWorlds(const Template& asset, int shiftedNode, const glm::vec3& shift, Pose& pose)
{
    for (std::size_t i = 0; i < asset.nodes.size(); ++i) {
        const Node& node = asset.nodes[i];
        assert(node.parent < static_cast<int>(i));
        const glm::mat4& parent = node.parent < 0
                                      ? asset.rootCorrection
                                      : pose.nodeWorld[static_cast<std::size_t>(node.parent)];
        pose.nodeWorld[i] =
            parent * (pose.locals[i].isMatrix ? *node.matrix : matrixOf(pose.locals[i]));
        if (static_cast<int>(i) == shiftedNode) {
            pose.nodeWorld[i][3] -= glm::vec4(shift, 0.0F);
        }
    }
}

} // namespace

void evaluatePose(const Template& asset, int clipIndex, float seconds, Pose& pose)
{
    resetToRest(asset, pose);
    int shiftedNode = -1;
    glm::vec3 shift{0.0F};
    if (clipIndex >= 0) {
        const Clip& clip = asset.clips[static_cast<std::size_t>(clipIndex)];
        const float within = std::clamp(seconds, 0.0F, clip.seconds);
        for (const Channel& channel : clip.channels) {
            apply(channel, clip.startSeconds + within,
                  pose.locals[static_cast<std::size_t>(channel.node)]);
        }
        if (clip.rootMotionNode >= 0 && clip.seconds > 0.0F) {
            shiftedNode = clip.rootMotionNode;
            shift = clip.rootMotion * (within / clip.seconds);
        }
    }
    chainWorlds(asset, shiftedNode, shift, pose);
    for (std::size_t i = 0; i < asset.bones.size(); ++i) {
        const Bone& bone = asset.bones[i];
        pose.bones[i] = pose.nodeWorld[static_cast<std::size_t>(bone.node)] * bone.inverseBind;
    }
}

} // namespace crowd::model
