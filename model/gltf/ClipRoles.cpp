// SPDX-License-Identifier: MIT
#include "model/gltf/ClipRoles.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/gltf/BodySamples.h"

namespace crowd::model::gltf {

namespace {

constexpr float kSlowestGait = 0.05F;  ///< m/s
constexpr float kMostOpenBody = 0.06F; ///< of the height, between first and last pose
constexpr float kSameWay = 0.5F;       ///< cosine: the same way, about

using Kind = NamedUse::Kind;

bool canBeGait(const Clip& clip)
{
    return clip.loop && clip.seconds > 0.1F && !clip.seatHeight;
}

/// The names that count for one of the gaits: plain ones, else those that say more, else guesses.
std::vector<std::size_t> bestNamed(const Template& asset, const std::vector<NamedUse>& uses,
                                   ClipRole role)
{
    for (const Kind kind : {Kind::Plain, Kind::Variant}) {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < uses.size(); ++i) {
            if (uses[i].kind == kind && uses[i].role == role && canBeGait(asset.clips[i])) {
                found.push_back(i);
            }
        }
        if (!found.empty()) {
            return found;
        }
    }
    return {};
}

bool hasGait(const Template& asset)
{
    return std::ranges::any_of(asset.clips, [](const Clip& clip) { return isGait(clip.role); });
}

void nameGaits(Template& asset, const std::vector<NamedUse>& uses)
{
    for (const ClipRole role : {ClipRole::Walk, ClipRole::Run, ClipRole::Fly}) {
        for (const std::size_t i : bestNamed(asset, uses, role)) {
            asset.clips[i].role = role;
        }
    }
    for (std::size_t i = 0; i < uses.size() && !hasGait(asset); ++i) {
        if (uses[i].kind == Kind::Weak && canBeGait(asset.clips[i])) {
            asset.clips[i].role = uses[i].role;
        }
    }
}

/// What gets on with its feet on the ground, whatever it is called.
void measuredGaits(Template& asset, const std::vector<NamedUse>& uses)
{
    const float border = std::sqrt(usualSpeedOf(ClipRole::Walk, asset.height) *
                                   usualSpeedOf(ClipRole::Run, asset.height));
    for (std::size_t i = 0; i < uses.size(); ++i) {
        Clip& clip = asset.clips[i];
        if (uses[i].kind == Kind::Unknown && canBeGait(clip) && clip.speed > kSlowestGait) {
            clip.role = clip.speed > border ? ClipRole::Run : ClipRole::Walk;
        }
    }
}

/// Gaits that go another way than most of them, or than the body faces, are none: somebody who
/// walks there would walk backwards.
void leaveOutOtherWays(Template& asset)
{
    glm::vec3 most(0.0F, 0.0F, 0.5F); // two that contradict each other: the way it faces
    for (const Clip& clip : asset.clips) {
        most += isGait(clip.role) ? clip.way : glm::vec3(0.0F);
    }
    for (Clip& clip : asset.clips) {
        const bool goesElsewhere =
            clip.way != glm::vec3(0.0F) && glm::dot(clip.way, most) < kSameWay * glm::length(most);
        if (isGait(clip.role) && goesElsewhere && !clip.hasRoleExtra) {
            clip.role = ClipRole::Other;
        }
    }
}

bool endsAsItBegan(const Template& asset, const Mesh& sample, int clip, Pose& pose)
{
    const float seconds = asset.clips[static_cast<std::size_t>(clip)].seconds;
    if (seconds <= 0.0F || sample.positions.empty()) {
        return true;
    }
    const auto begin = pointsAt(asset, sample, clip, 0.0F, pose);
    const auto end = pointsAt(asset, sample, clip, seconds, pose);
    float sum = 0.0F;
    for (std::size_t i = 0; i < begin.size(); ++i) {
        sum += glm::dot(end[i] - begin[i], end[i] - begin[i]);
    }
    return std::sqrt(sum / static_cast<float>(begin.size())) < kMostOpenBody * asset.height;
}

/// Standing and sitting: what goes on for ever. Getting up and sitting down end elsewhere.
void nameRests(Template& asset, const std::vector<NamedUse>& uses)
{
    if (asset.levels.empty() || workOfAPose(asset) * 2.0 > kMostWork) {
        return;
    }
    const Mesh sample = evenExcerpt(asset.levels.front());
    Pose pose;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        Clip& clip = asset.clips[i];
        const bool sits = uses[i].isOf(ClipRole::Sit) || clip.seatHeight.has_value();
        if (clip.hasRoleExtra || isGait(clip.role) || !clip.loop ||
            !(sits || uses[i].isOf(ClipRole::Idle)) ||
            !endsAsItBegan(asset, sample, static_cast<int>(i), pose)) {
            continue;
        }
        clip.role = sits ? ClipRole::Sit : ClipRole::Idle;
    }
}

} // namespace

std::vector<NamedUse> usesOf(const Template& asset)
{
    std::vector<std::string> names;
    for (const Clip& clip : asset.clips) {
        names.push_back(clip.name);
    }
    return namedUses(names);
}

void proposeRoles(Template& asset, const std::vector<NamedUse>& uses)
{
    std::vector<ClipRole> given;
    for (const Clip& clip : asset.clips) {
        given.push_back(clip.role);
    }
    nameGaits(asset, uses);
    if (!hasGait(asset)) {
        measuredGaits(asset, uses);
    }
    for (std::size_t i = 0; i < given.size(); ++i) {
        asset.clips[i].role = asset.clips[i].hasRoleExtra ? given[i] : asset.clips[i].role;
    }
    leaveOutOtherWays(asset);
    for (Clip& clip : asset.clips) {
        if (isGait(clip.role) && clip.isAloft && !clip.hasRoleExtra) {
            clip.speed = usualSpeedOf(clip.role, asset.height);
            clip.role = ClipRole::Fly;
        }
        if (isGait(clip.role) && clip.speed <= kSlowestGait && !clip.hasSpeedExtra) {
            clip.speed = usualSpeedOf(clip.role, asset.height);
        }
    }
    nameRests(asset, uses);
    Clip& standing = asset.clips[static_cast<std::size_t>(asset.defaultClip)];
    if (standing.role == ClipRole::Other && !standing.hasRoleExtra) {
        standing.role = ClipRole::Idle;
    }
}

} // namespace crowd::model::gltf
