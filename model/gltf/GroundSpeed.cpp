// SPDX-License-Identifier: MIT
#include "model/gltf/GroundSpeed.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/gltf/BodySamples.h"
#include "model/gltf/FootStride.h"

namespace crowd::model::gltf {

namespace {

constexpr float kLeastShift = 0.05F;     ///< of the height: less is no root motion
constexpr float kMostChange = 0.35F;     ///< change of shape against the shift
constexpr float kMostOpen = 0.05F;       ///< of the height, between first and last pose
constexpr float kContactBand = 0.015F;   ///< of the height above the lowest point
constexpr float kLeastSteadiness = 0.5F; ///< |mean velocity| against mean |velocity|
constexpr float kLeastContact = 0.2F;    ///< share of the clip with a foot on the ground
constexpr float kLeastSpeed = 0.1F;      ///< heights a second

/// The shift of the body over the clip, zero where it is small or the body also changes its shape.
glm::vec3 netShift(const Template& asset, const Mesh& sample, int clip, Pose& pose)
{
    const float seconds = asset.clips[static_cast<std::size_t>(clip)].seconds;
    const std::vector<glm::vec3> begin = pointsAt(asset, sample, clip, 0.0F, pose);
    const std::vector<glm::vec3> end = pointsAt(asset, sample, clip, seconds, pose);
    glm::vec3 mean(0.0F);
    for (std::size_t i = 0; i < begin.size(); ++i) {
        mean += horizontal(end[i] - begin[i]) / static_cast<float>(begin.size());
    }
    float change = 0.0F;
    for (std::size_t i = 0; i < begin.size(); ++i) {
        const glm::vec3 rest = end[i] - begin[i] - mean;
        change += glm::dot(rest, rest) / static_cast<float>(begin.size());
    }
    const float length = glm::length(mean);
    const bool isShift = length > kLeastShift * asset.height && std::isfinite(length) &&
                         std::sqrt(change) < kMostChange * length;
    return isShift ? mean : glm::vec3(0.0F);
}

/// The lowest node that all bones hang on; -1 if there is none.
int commonAncestor(const Template& asset)
{
    std::vector<std::size_t> below(asset.nodes.size(), 0);
    for (const Bone& bone : asset.bones) {
        ++below[static_cast<std::size_t>(bone.node)];
    }
    // Children come after their parents, so that the first one found from behind is the lowest.
    for (std::size_t i = below.size(); i-- > 0;) {
        if (below[i] == asset.bones.size()) {
            return static_cast<int>(i);
        }
        if (asset.nodes[i].parent >= 0) {
            below[static_cast<std::size_t>(asset.nodes[i].parent)] += below[i];
        }
    }
    return -1;
}

/// The shift of the node that carries the whole body, where one does: the mean over vertices also
/// has the last bit of the stride in it.
glm::vec3 nodeShift(const Template& asset, int clip, int node, const glm::vec3& mean, Pose& pose)
{
    const auto moved = [&](std::size_t i, const std::vector<glm::mat4>& begin) {
        return horizontal(glm::vec3(pose.nodeWorld[i][3] - begin[i][3]));
    };
    evaluatePose(asset, clip, 0.0F, pose);
    const std::vector<glm::mat4> begin = pose.nodeWorld;
    evaluatePose(asset, clip, asset.clips[static_cast<std::size_t>(clip)].seconds, pose);
    for (std::size_t i = static_cast<std::size_t>(node); i < asset.nodes.size(); ++i) {
        if (glm::length(moved(i, begin) - mean) < kMostChange * glm::length(mean)) {
            return moved(i, begin);
        }
    }
    return mean;
}

bool findRootMotion(Template& asset, const Mesh& sample, int clip, int root, bool remove,
                    Pose& pose)
{
    Clip& target = asset.clips[static_cast<std::size_t>(clip)];
    if (root < 0 || target.seconds <= 0.0F) {
        return false;
    }
    const glm::vec3 mean = netShift(asset, sample, clip, pose);
    if (mean == glm::vec3(0.0F)) {
        return false;
    }
    const glm::vec3 shift = nodeShift(asset, clip, root, mean, pose);
    target.speed = glm::length(shift) / target.seconds;
    target.way = glm::normalize(shift);
    if (remove) {
        target.rootMotion = shift;
        target.rootMotionNode = root;
    }
    return true;
}

/// Whether the body ends in the pose it began with, as loops do.
bool isClosed(const Template& asset, const Mesh& feet, int clip, Pose& pose)
{
    const float seconds = asset.clips[static_cast<std::size_t>(clip)].seconds;
    const std::vector<glm::vec3> begin = pointsAt(asset, feet, clip, 0.0F, pose);
    const std::vector<glm::vec3> end = pointsAt(asset, feet, clip, seconds, pose);
    float sum = 0.0F;
    for (std::size_t i = 0; i < begin.size(); ++i) {
        sum += glm::dot(end[i] - begin[i], end[i] - begin[i]);
    }
    return std::sqrt(sum / static_cast<float>(begin.size())) < kMostOpen * asset.height;
}

/// Height of the ground: the lowest point at most moments, with some that sink in and, in a run,
/// many in the air.
float groundOf(const std::vector<std::vector<glm::vec3>>& points)
{
    std::vector<float> lowest;
    lowest.reserve(points.size());
    for (const std::vector<glm::vec3>& at : points) {
        lowest.push_back(std::min_element(at.begin(), at.end(), [](const auto& a, const auto& b) {
                             return a.y < b.y;
                         })->y);
    }
    const auto quarter = lowest.begin() + static_cast<std::ptrdiff_t>(lowest.size() / 4);
    std::nth_element(lowest.begin(), quarter, lowest.end());
    return *quarter;
}

/// Velocities of the points that stay in the band above the ground between two moments.
struct Contacts
{
    std::vector<glm::vec3> velocities;
    int moments = 0; ///< with at least one
};

Contacts findContacts(const std::vector<std::vector<glm::vec3>>& points, float band, float step)
{
    Contacts contacts;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const std::size_t before = contacts.velocities.size();
        for (std::size_t v = 0; v < points[i].size(); ++v) {
            if (points[i][v].y < band && points[i + 1][v].y < band) {
                contacts.velocities.push_back(horizontal(points[i + 1][v] - points[i][v]) / step);
            }
        }
        contacts.moments += contacts.velocities.size() > before ? 1 : 0;
    }
    return contacts;
}

/// The median along the mean direction; zero where the velocities do not agree.
glm::vec3 commonVelocity(const std::vector<glm::vec3>& velocities)
{
    glm::vec3 sum(0.0F);
    float lengths = 0.0F;
    for (const glm::vec3& velocity : velocities) {
        sum += velocity;
        lengths += glm::length(velocity);
    }
    if (lengths <= 0.0F || glm::length(sum) < kLeastSteadiness * lengths) {
        return glm::vec3(0.0F);
    }
    const glm::vec3 way = glm::normalize(sum);
    std::vector<float> along;
    along.reserve(velocities.size());
    for (const glm::vec3& velocity : velocities) {
        along.push_back(glm::dot(velocity, way));
    }
    const auto middle = along.begin() + static_cast<std::ptrdiff_t>(along.size() / 2);
    std::nth_element(along.begin(), middle, along.end());
    return way * *middle;
}

glm::vec3 footVelocityOf(const Template& asset, const Mesh& feet, int clip, Pose& pose)
{
    if (!isClosed(asset, feet, clip, pose)) {
        return glm::vec3(0.0F);
    }
    const float seconds = asset.clips[static_cast<std::size_t>(clip)].seconds;
    const int moments = momentsOf(asset.clips[static_cast<std::size_t>(clip)]);
    const float step = seconds / static_cast<float>(moments);
    const auto points = pointsOver(asset, feet, clip, moments, pose);
    const float band = groundOf(points) + kContactBand * asset.height;
    const Contacts contacts = findContacts(points, band, step);
    const glm::vec3 velocity = commonVelocity(contacts.velocities);
    const bool isWalk =
        static_cast<float>(contacts.moments) > kLeastContact * static_cast<float>(moments) &&
        glm::length(velocity) > kLeastSpeed * asset.height;
    return isWalk ? velocity : glm::vec3(0.0F);
}

bool canMove(const Template& asset, const Clip& clip)
{
    return clip.seconds > 0.1F && !clip.seatHeight && !asset.bones.empty() && asset.height > 0.0F;
}

} // namespace

glm::vec3 footVelocity(const Template& asset, int clip)
{
    if (asset.levels.empty() || workOfAPose(asset) * kMaxMoments > kMostWork ||
        !canMove(asset, asset.clips[static_cast<std::size_t>(clip)])) {
        return glm::vec3(0.0F);
    }
    Pose pose;
    return footVelocityOf(asset, lowExcerpt(asset), clip, pose);
}

namespace {

/// A foot that touches the ground tells most; a gait whose feet do not has its stride.
void findInPlaceSpeed(Template& asset, const Mesh& feet, int clip, const NamedUse& use, Pose& pose)
{
    Clip& target = asset.clips[static_cast<std::size_t>(clip)];
    glm::vec3 ground = footVelocityOf(asset, feet, clip, pose);
    const bool isGaitByName = isGait(use.role) && use.kind != NamedUse::Kind::Action;
    if (isGaitByName) {
        const FootStride stride = footStride(asset, feet, clip, use.role, ground, pose);
        target.isAloft = stride.isAloft;
        ground = stride.isAloft ? glm::vec3(0.0F) : stride.ground;
    }
    const float speed = glm::length(ground);
    target.way = speed > 0.0F ? -ground / speed : glm::vec3(0.0F);
    target.speed = speed;
}

} // namespace

void findGroundSpeeds(Template& asset, bool removeRootMotion, const std::vector<NamedUse>& uses)
{
    if (asset.levels.empty() || asset.levels.front().positions.empty()) {
        return;
    }
    const Mesh sample = evenExcerpt(asset.levels.front());
    const Mesh feet = lowExcerpt(asset);
    const int root = commonAncestor(asset);
    const double work = workOfAPose(asset);
    if (work * 4.0 > kMostWork) {
        return; // no character has so many nodes and clips
    }
    const bool canLookAtFeet = work * kMaxMoments < kMostWork;
    Pose pose;
    for (std::size_t i = 0; i < asset.clips.size(); ++i) {
        const int index = static_cast<int>(i);
        if (!findRootMotion(asset, sample, index, root, removeRootMotion, pose) && canLookAtFeet &&
            canMove(asset, asset.clips[i]) && !asset.clips[i].hasSpeedExtra) {
            findInPlaceSpeed(asset, feet, index, uses[i], pose);
        }
    }
}

} // namespace crowd::model::gltf
