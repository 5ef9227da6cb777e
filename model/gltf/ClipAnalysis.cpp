// SPDX-License-Identifier: MIT
#include "model/gltf/ClipAnalysis.h"

#include <algorithm>
#include <cmath>

#include "model/bake/Pose.h"
#include "model/bake/Skinning.h"
#include "model/gltf/BodySize.h"
#include "model/gltf/ClipRoles.h"
#include "model/gltf/GroundSpeed.h"

namespace crowd::model::gltf {

namespace {

/// Lower case, letters and digits only: "T-Pose" and "t_pose" are the same.
std::string simplified(const std::string& name)
{
    std::string simple;
    // Blender exports actions as "Armature|Idle".
    for (const char c : name.substr(name.find_last_of('|') + 1)) {
        if (c >= 'A' && c <= 'Z') {
            simple.push_back(static_cast<char>(c - 'A' + 'a'));
        } else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
            simple.push_back(c);
        }
    }
    return simple;
}

bool containsAny(const std::string& text, std::initializer_list<const char*> words)
{
    return std::any_of(words.begin(), words.end(),
                       [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// Lower is better.
int standingRank(const Clip& clip)
{
    const std::string name = simplified(clip.name);
    if (containsAny(name, {"reset", "static", "bind", "tpose", "apose", "restpose"})) {
        return 9;
    }
    const bool isOtherwise =
        containsAny(name, {"sit", "lie", "lying", "jump", "fall", "floor", "crouch", "swim", "fly",
                           "hang", "climb", "crawl", "death", "dead"});
    if (clip.seatHeight) {
        return 7;
    }
    if (name == "idle") {
        return 0;
    }
    if (containsAny(name, {"idle"})) {
        return isOtherwise ? 4 : 1;
    }
    if (containsAny(name, {"stand", "breath", "wait", "relax", "survey"})) {
        return isOtherwise ? 4 : 2;
    }
    if (containsAny(name, {"walk", "fly", "swim", "hover", "move"})) {
        return 5;
    }
    return clip.seconds > 0.0F ? 6 : 8;
}

} // namespace

int chooseDefaultClip(const std::vector<Clip>& clips)
{
    const auto best =
        std::min_element(clips.begin(), clips.end(), [](const Clip& a, const Clip& b) {
            return standingRank(a) < standingRank(b);
        });
    return best == clips.end() ? 0 : static_cast<int>(best - clips.begin());
}

Bounds boundsAt(const Template& asset, int clip, float seconds)
{
    Bounds bounds;
    if (asset.levels.empty()) {
        return bounds;
    }
    const Mesh& mesh = asset.levels.front();
    Pose pose;
    evaluatePose(asset, clip, seconds, pose);
    std::vector<glm::vec3> positions(mesh.positions.size());
    skin(mesh, pose.bones, positions, {});
    for (const Submesh& submesh : mesh.submeshes) {
        const bool isShown =
            submesh.part < 0 || asset.parts[static_cast<std::size_t>(submesh.part)].shownByDefault;
        for (std::uint32_t i = 0; isShown && i < submesh.indexCount; ++i) {
            bounds.addPlace(positions[mesh.indices[submesh.firstIndex + i]]);
        }
    }
    return bounds;
}

void analyseClips(Template& asset, bool removeRootMotion)
{
    asset.defaultClip = chooseDefaultClip(asset.clips);
    const auto seated = std::find_if(asset.clips.begin(), asset.clips.end(),
                                     [](const Clip& clip) { return clip.seatHeight.has_value(); });
    asset.seatedClip =
        seated == asset.clips.end() ? -1 : static_cast<int>(seated - asset.clips.begin());
    asset.bounds = boundsAt(asset, asset.defaultClip, 0.0F);
    asset.height = asset.bounds.size().y;
    asset.footprint = footprintOf(asset);
    const std::vector<NamedUse> uses = usesOf(asset);
    findGroundSpeeds(asset, removeRootMotion, uses);
    proposeRoles(asset, uses);
    if (asset.seatedClip < 0) {
        const auto sits = std::ranges::find(asset.clips, ClipRole::Sit, &Clip::role);
        asset.seatedClip =
            sits == asset.clips.end() ? -1 : static_cast<int>(sits - asset.clips.begin());
    }
}

} // namespace crowd::model::gltf
