// SPDX-License-Identifier: MIT
#include "model/gltf/GltfAnimations.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "model/gltf/GltfAccessors.h"
#include "model/gltf/GltfJson.h"
#include "model/gltf/GltfLimits.h"
#include "model/gltf/GltfNames.h"
#include "model/gltf/GltfValue.h"

namespace crowd::model::gltf {

namespace {

std::optional<ChannelPath> pathOf(const std::string& path)
{
    if (path == "translation") {
        return ChannelPath::Translation;
    }
    if (path == "rotation") {
        return ChannelPath::Rotation;
    }
    if (path == "scale") {
        return ChannelPath::Scale;
    }
    return std::nullopt;
}

Interpolation interpolationOf(const std::string& name)
{
    return name == "STEP"          ? Interpolation::Step
           : name == "CUBICSPLINE" ? Interpolation::CubicSpline
                                   : Interpolation::Linear;
}

/// Keeps the keys whose time and values are numbers and whose time comes after the one before.
std::size_t dropBadKeys(Channel& channel)
{
    const std::size_t stride = channel.values.size() / channel.times.size();
    std::size_t kept = 0;
    float last = -std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < channel.times.size(); ++i) {
        const float* values = channel.values.data() + i * stride;
        if (!std::isfinite(channel.times[i]) || channel.times[i] <= last ||
            !std::all_of(values, values + stride, [](float v) { return std::isfinite(v); })) {
            continue;
        }
        last = channel.times[i];
        channel.times[kept] = last;
        std::copy(values, values + stride,
                  channel.values.begin() + static_cast<std::ptrdiff_t>(kept * stride));
        ++kept;
    }
    const std::size_t dropped = channel.times.size() - kept;
    channel.times.resize(kept);
    channel.values.resize(kept * stride);
    return dropped;
}

/// Quaternions of length one, except tangents; null ones become no rotation.
void normalizeRotations(Channel& channel)
{
    const std::size_t step = channel.interpolation == Interpolation::CubicSpline ? 12 : 4;
    for (std::size_t at = step == 12 ? 4 : 0; at + 4 <= channel.values.size(); at += step) {
        float* q = channel.values.data() + at;
        const float length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int c = 0; c < 4; ++c) {
            q[c] = length > 0.0F ? q[c] / length : (c == 3 ? 1.0F : 0.0F);
        }
    }
}

/// From here on the node is animated component by component, so its matrix has to be taken apart.
void splitMatrix(Node& node)
{
    if (!node.matrix) {
        return;
    }
    const glm::mat4& m = *node.matrix;
    node.translation = glm::vec3(m[3]);
    glm::mat3 turn(m);
    node.scale = {glm::length(turn[0]), glm::length(turn[1]), glm::length(turn[2])};
    if (glm::determinant(turn) < 0.0F) {
        node.scale.x = -node.scale.x;
    }
    for (int i = 0; i < 3; ++i) {
        turn[i] = node.scale[i] != 0.0F ? turn[i] / node.scale[i] : glm::mat3(1.0F)[i];
    }
    node.rotation = glm::normalize(glm::quat_cast(turn));
    node.matrix.reset();
}

class ClipBuilder
{
public:
    ClipBuilder(const GltfFile& file, const SceneNodes& scene, Template& asset)
        : m_model(*file.model), m_scene(scene), m_asset(asset)
    {
    }

    Result<void> run()
    {
        for (std::size_t i = 0; i < m_model.animations.size(); ++i) {
            if (Result<void> added = addClip(i); !added) {
                return added;
            }
        }
        if (m_asset.clips.empty()) {
            Clip pose;
            pose.name = "static";
            pose.isMadeUp = true;
            m_asset.clips.push_back(std::move(pose));
        }
        if (m_dropped > 0) {
            m_asset.warnings.emplace_back(
                QT_TRANSLATE_NOOP(
                    "Messages",
                    "%1 animation keys are out of order or no numbers; they are left out."),
                m_dropped);
        }
        return {};
    }

private:
    Result<void> addClip(std::size_t index)
    {
        const tinygltf::Animation& from = m_model.animations[index];
        Clip clip;
        clip.name =
            m_names.unique(from.name.empty() ? "animation_" + std::to_string(index) : from.name);
        clip.loop = flagIn(from.extras, "loop").value_or(true);
        clip.seatHeight = floatIn(from.extras, "seatHeight");
        clip.speed = floatIn(from.extras, "speed").value_or(0.0F);
        clip.hasSpeedExtra = floatIn(from.extras, "speed").has_value();
        const std::optional<ClipRole> role = clipRoleOf(textIn(from.extras, "role"));
        clip.role = role.value_or(ClipRole::Other);
        clip.hasRoleExtra = role.has_value();
        float first = std::numeric_limits<float>::infinity();
        float last = -first;
        for (std::size_t i = 0; i < from.channels.size(); ++i) {
            const std::string where = place("animations", index) + "." + place("channels", i);
            Result<Channel> channel = readChannel(from, from.channels[i], where);
            if (!channel) {
                return channel.error();
            }
            if (channel.value().times.empty()) {
                continue;
            }
            first = std::min(first, channel.value().times.front());
            last = std::max(last, channel.value().times.back());
            if (!channel.value().values.empty()) {
                clip.channels.push_back(std::move(channel).value());
            }
        }
        if (first <= last) {
            clip.startSeconds = first;
            clip.seconds = last - first;
        }
        if (clip.seconds > kMaxClipSeconds) {
            return Error{QT_TRANSLATE_NOOP("Messages", "%1 is longer than an hour"),
                         place("animations", index)};
        }
        m_asset.clips.push_back(std::move(clip));
        return {};
    }

    /// Without values where it moves nothing that we draw; its times still count for the clip.
    Result<Channel> readChannel(const tinygltf::Animation& clip,
                                const tinygltf::AnimationChannel& from, const std::string& where)
    {
        const auto& sampler = clip.samplers[static_cast<std::size_t>(from.sampler)];
        const tinygltf::Accessor& input =
            m_model.accessors[static_cast<std::size_t>(sampler.input)];
        const tinygltf::Accessor& output =
            m_model.accessors[static_cast<std::size_t>(sampler.output)];
        if (input.type != TINYGLTF_TYPE_SCALAR) {
            return Error{
                QT_TRANSLATE_NOOP("Messages", "%1: the times of its keys are not single numbers"),
                where};
        }
        m_floats += input.count + output.count * 4;
        if (m_floats > kMaxAnimationFloats) {
            return Error{
                QT_TRANSLATE_NOOP("Messages", "%1: the animations have more than %2 numbers"),
                where, kMaxAnimationFloats};
        }
        Channel channel;
        channel.times = readFloats(m_model, sampler.input).values;
        const std::optional<ChannelPath> path = pathOf(from.target_path);
        const int node = from.target_node < 0
                             ? -1
                             : m_scene.ofFileNode[static_cast<std::size_t>(from.target_node)];
        if (!path || node < 0 || channel.times.empty()) {
            keepFiniteTimes(channel.times);
            return channel;
        }
        channel.node = node;
        channel.path = *path;
        channel.interpolation = interpolationOf(sampler.interpolation);
        if (auto read = readValues(channel, output, sampler.output, where); !read) {
            return read.error();
        }
        splitMatrix(m_asset.nodes[static_cast<std::size_t>(node)]);
        return channel;
    }

    /// The values of a channel's keys; bad ones are dropped and counted.
    Result<void> readValues(Channel& channel, const tinygltf::Accessor& output, int accessor,
                            const std::string& where)
    {
        const bool turns = channel.path == ChannelPath::Rotation;
        const std::size_t keys =
            channel.times.size() * (channel.interpolation == Interpolation::CubicSpline ? 3 : 1);
        if (output.type != (turns ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3) ||
            output.count < keys) {
            return Error{
                QT_TRANSLATE_NOOP(
                    "Messages", "%1: it has %2 values of the wrong number or type for its %3 keys"),
                where, output.count, channel.times.size()};
        }
        FloatArray values = readFloats(m_model, accessor);
        values.values.resize(keys * values.components);
        channel.values = std::move(values.values);
        m_dropped += dropBadKeys(channel);
        if (turns) {
            normalizeRotations(channel);
        }
        return {};
    }

    static void keepFiniteTimes(std::vector<float>& times)
    {
        std::erase_if(times, [](float time) { return !std::isfinite(time); });
        std::sort(times.begin(), times.end());
    }

    const tinygltf::Model& m_model;
    const SceneNodes& m_scene;
    Template& m_asset;
    NameSet m_names;
    std::uint64_t m_floats = 0;
    std::size_t m_dropped = 0;
};

} // namespace

Result<void> buildClips(const GltfFile& file, const SceneNodes& scene, Template& asset)
{
    return ClipBuilder(file, scene, asset).run();
}

} // namespace crowd::model::gltf
