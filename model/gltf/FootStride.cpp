// SPDX-License-Identifier: MIT
#include "model/gltf/FootStride.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <glm/geometric.hpp>

#include "model/gltf/BodySamples.h"

namespace crowd::model::gltf {

namespace {

constexpr float kFootHeight = 0.12F;    ///< of the height: what is lower belongs to a foot
constexpr float kFootDepth = 0.06F;     ///< of the height: as low as the lowest foot, about
constexpr float kLowShare = 0.2F;       ///< of a foot's way up and down: it is on the ground
constexpr float kFlatFoot = 0.01F;      ///< of the height: it does not lift
constexpr float kAloft = 0.08F;         ///< of the height
constexpr float kLeastSwing = 0.04F;    ///< of the height
constexpr float kLeastAgreement = 0.3F; ///< |mean velocity| against mean |velocity|
constexpr float kMostAgainst = 2.5F;    ///< times what the swing of the feet says
constexpr float kMostSwing = 1.4F;      ///< times the usual: that is no foot
/// Share of its cycle in which a foot swings back as fast as the ground, about: of people whose
/// speed is known.
constexpr float kWalkDuty = 0.6F;
constexpr float kRunDuty = 0.43F;

/// The lowest part of one limb over a clip.
struct FootTrack
{
    std::vector<glm::vec3> middle; ///< one per moment
    std::vector<float> lowest;
    float low = 0.0F; ///< over all moments
    float high = 0.0F;
};

std::size_t strongestBone(const Mesh& mesh, std::size_t vertex)
{
    const auto influences = static_cast<std::size_t>(mesh.influencesPerVertex);
    const auto first = mesh.weights.begin() + static_cast<std::ptrdiff_t>(vertex * influences);
    const auto best = std::max_element(first, first + static_cast<std::ptrdiff_t>(influences));
    return mesh.bones[vertex * influences + static_cast<std::size_t>(best - first)];
}

/// Vertices of feet, by the bone that carries them; only those that are low in the default pose.
std::map<std::size_t, std::vector<std::size_t>> limbsOf(const Template& asset, const Mesh& feet,
                                                        Pose& pose)
{
    const auto points = pointsAt(asset, feet, asset.defaultClip, 0.0F, pose);
    float lowest = points.front().y;
    for (const glm::vec3& point : points) {
        lowest = std::min(lowest, point.y);
    }
    std::map<std::size_t, std::vector<std::size_t>> limbs;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (points[v].y < lowest + kFootHeight * asset.height) {
            limbs[strongestBone(feet, v)].push_back(v);
        }
    }
    return limbs;
}

FootTrack trackOf(const std::vector<std::vector<glm::vec3>>& points,
                  const std::vector<std::size_t>& vertices)
{
    FootTrack track;
    for (const std::vector<glm::vec3>& at : points) {
        glm::vec3 sum(0.0F);
        float lowest = at[vertices.front()].y;
        for (const std::size_t v : vertices) {
            sum += at[v];
            lowest = std::min(lowest, at[v].y);
        }
        track.middle.push_back(sum / static_cast<float>(vertices.size()));
        track.lowest.push_back(lowest);
    }
    const auto [low, high] = std::ranges::minmax(track.lowest);
    track.low = low;
    track.high = high;
    return track;
}

/// Those that come down to the ground.
std::vector<FootTrack> feetOf(const Template& asset, const Mesh& feet,
                              const std::vector<std::vector<glm::vec3>>& points, Pose& pose)
{
    std::vector<FootTrack> tracks;
    for (const auto& [bone, vertices] : limbsOf(asset, feet, pose)) {
        tracks.push_back(trackOf(points, vertices));
    }
    const float ground = std::ranges::min(tracks, {}, &FootTrack::low).low;
    std::erase_if(tracks, [&](const FootTrack& track) {
        return track.low > ground + kFootDepth * asset.height;
    });
    return tracks;
}

/// The middle of the narrowest range that half of the values are in: a foot on the ground has one
/// speed, one that comes or goes any.
float modeOf(std::vector<float> values)
{
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    std::size_t best = 0;
    for (std::size_t i = 0; i + half < values.size(); ++i) {
        if (values[i + half] - values[i] < values[best + half] - values[best]) {
            best = i;
        }
    }
    return values[best + half / 2];
}

/// Of the feet while they are low; zero where they do not agree.
glm::vec3 lowVelocity(const std::vector<FootTrack>& feet, float step, float height)
{
    std::vector<glm::vec3> velocities;
    for (const FootTrack& foot : feet) {
        const float lift = foot.high - foot.low;
        const float low =
            lift < kFlatFoot * height ? foot.high + 1.0F : foot.low + kLowShare * lift;
        for (std::size_t i = 0; i + 1 < foot.middle.size(); ++i) {
            if (foot.lowest[i] <= low && foot.lowest[i + 1] <= low) {
                velocities.push_back(horizontal(foot.middle[i + 1] - foot.middle[i]) / step);
            }
        }
    }
    glm::vec3 sum(0.0F);
    float lengths = 0.0F;
    for (const glm::vec3& velocity : velocities) {
        sum += velocity;
        lengths += glm::length(velocity);
    }
    if (lengths <= 0.0F || glm::length(sum) < kLeastAgreement * lengths) {
        return glm::vec3(0.0F);
    }
    const glm::vec3 way = glm::normalize(sum);
    std::vector<float> along;
    along.reserve(velocities.size());
    for (const glm::vec3& velocity : velocities) {
        along.push_back(glm::dot(velocity, way));
    }
    return way * std::max(modeOf(along), 0.0F);
}

/// How far a foot swings to and fro, and how often in the clip.
struct Swing
{
    float metres = 0.0F;
    int times = 1;
};

Swing swingOf(const FootTrack& foot, const glm::vec3& way)
{
    std::vector<float> along;
    for (const glm::vec3& at : foot.middle) {
        along.push_back(glm::dot(at, way));
    }
    const auto [least, most] = std::ranges::minmax(along);
    // Forwards through the middle, after having been well behind it.
    const float behind = least + 0.3F * (most - least);
    const float middle = 0.5F * (least + most);
    int times = 0;
    bool wasBehind = along.back() < behind || along.front() < behind;
    for (const float at : along) {
        times += wasBehind && at > middle ? 1 : 0;
        wasBehind = at < behind || (wasBehind && at <= middle);
    }
    return {most - least, std::max(times, 1)};
}

/// The middle one of those feet that swing at all.
Swing usualSwing(const std::vector<FootTrack>& feet, const glm::vec3& way)
{
    std::vector<Swing> swings;
    float widest = 0.0F;
    for (const FootTrack& foot : feet) {
        swings.push_back(swingOf(foot, way));
        widest = std::max(widest, swings.back().metres);
    }
    std::erase_if(swings, [&](const Swing& swing) { return swing.metres < 0.5F * widest; });
    std::ranges::stable_sort(swings, {}, &Swing::metres);
    return swings.empty() ? Swing{} : swings[(swings.size() - 1) / 2];
}

/// Without what also hangs low and swings further than feet do.
void leaveOutOthers(std::vector<FootTrack>& feet)
{
    constexpr glm::vec3 kAlong(0.0F, 0.0F, 1.0F);
    const float most = kMostSwing * usualSwing(feet, kAlong).metres;
    std::erase_if(feet, [&](const FootTrack& foot) { return swingOf(foot, kAlong).metres > most; });
}

} // namespace

FootStride footStride(const Template& asset, const Mesh& feet, int clip, ClipRole role,
                      const glm::vec3& measured, Pose& pose)
{
    const Clip& source = asset.clips[static_cast<std::size_t>(clip)];
    if (feet.positions.empty() || source.seconds <= 0.0F || asset.height <= 0.0F) {
        return {measured};
    }
    const int moments = momentsOf(source);
    const auto points = pointsOver(asset, feet, clip, moments, pose);
    std::vector<FootTrack> tracks = feetOf(asset, feet, points, pose);
    FootStride stride{measured};
    stride.isAloft = std::ranges::min(tracks, {}, &FootTrack::low).low > kAloft * asset.height;
    leaveOutOthers(tracks);
    const float step = source.seconds / static_cast<float>(moments);
    const glm::vec3 low = lowVelocity(tracks, step, asset.height);
    const glm::vec3 known = measured != glm::vec3(0.0F) ? measured : low;
    const glm::vec3 way =
        known != glm::vec3(0.0F) ? glm::normalize(known) : glm::vec3(0.0F, 0.0F, -1.0F);
    const Swing swing = usualSwing(tracks, way);
    if (swing.metres < kLeastSwing * asset.height) {
        return stride;
    }
    const float duty = role == ClipRole::Run ? kRunDuty : kWalkDuty;
    const float bySwing = swing.metres * static_cast<float>(swing.times) / (duty * source.seconds);
    const auto fits = [bySwing](const glm::vec3& ground) {
        const float share = glm::length(ground) / bySwing;
        return share > 1.0F / kMostAgainst && share < kMostAgainst;
    };
    stride.ground = fits(measured) ? measured : fits(low) ? low : way * bySwing;
    return stride;
}

} // namespace crowd::model::gltf
