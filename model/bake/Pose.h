// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "model/template/Template.h"

/// Where the nodes and bones of a template are at one moment of a clip. Pure functions of their
/// arguments, in float: the same bits on every thread.
namespace crowd::model {

/// Result and scratch of evaluatePose. Reuse one per thread: nothing is allocated after the first
/// evaluation of a template.
struct Pose
{
    struct Local
    {
        glm::vec3 translation;
        glm::quat rotation;
        glm::vec3 scale;
        bool isMatrix; ///< the node's own matrix stands in for the three above
    };

    std::vector<Local> locals;        ///< one a node, relative to its parent
    std::vector<glm::mat4> nodeWorld; ///< one a node, template frame, metres
    std::vector<glm::mat4> bones;     ///< one a bone: world(node) * inverseBind, for skin()
};

/// The pose of clip `clipIndex` at `seconds` after the clip's start, clamped to its length.
/// Rotations go the short way round (spherical interpolation), the rest is linear; steps and cubic
/// splines as in glTF 2.0, appendix C. The clip's root motion is removed, the template's root
/// correction applied. `clipIndex` -1: the rest pose.
void evaluatePose(const Template& asset, int clipIndex, float seconds, Pose& pose);

} // namespace crowd::model
