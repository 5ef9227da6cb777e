// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "model/template/Template.h"

namespace tinygltf {
class Model;
class Node;
} // namespace tinygltf

/// The nodes of the default scene, and which of them draw meshes at which level of detail.
namespace crowd::model::gltf {

/// Template nodes with the way back to the file's.
struct SceneNodes
{
    std::vector<Node> nodes;          ///< depth first, in the file's order
    std::vector<int> fileNode;        ///< of each
    std::vector<char> isDrawn;        ///< false for joints outside the scene
    std::vector<int> ofFileNode;      ///< index into nodes, -1 for what the scene does not use
    std::vector<glm::mat4> restWorld; ///< file's frame, without any correction
};

/// The default scene, else the first, else all root nodes; with them the joints of skins in use and
/// the alternatives that MSFT_lod names.
[[nodiscard]] SceneNodes collectNodes(const tinygltf::Model& model);

/// The file's nodes that MSFT_lod names as coarser forms of this one.
[[nodiscard]] std::vector<int> alternatives(const tinygltf::Node& node);

/// Local matrix of a template node at rest.
[[nodiscard]] glm::mat4 restLocal(const Node& node);

} // namespace crowd::model::gltf
