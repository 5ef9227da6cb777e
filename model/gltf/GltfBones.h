// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "model/gltf/GltfNodes.h"
#include "model/template/Template.h"

namespace tinygltf {
struct Skin;
} // namespace tinygltf

namespace crowd::model::gltf {

/// The bones of all skins and of all meshes without one; equal ones are shared. Writes `bones`.
class BoneTable
{
public:
    BoneTable(const tinygltf::Model& model, const SceneNodes& scene, std::vector<Bone>& bones);

    /// Bones of a skin, in the order of its joints. Stays valid.
    const std::vector<std::uint16_t>& ofSkin(int skin);
    std::uint16_t ofNode(int node);
    /// There are more than kMaxBones: those beyond are all the same, and wrong.
    [[nodiscard]] bool isOverfull() const { return m_isOverfull; }
    /// Whether a bone turns front faces over at rest.
    [[nodiscard]] bool mirrors(std::uint16_t bone) const { return m_mirrors[bone] != 0; }

private:
    using Key = std::pair<int, std::array<std::uint32_t, 16>>;
    std::vector<std::uint16_t> makeSkin(const tinygltf::Skin& skin);
    std::uint16_t add(int node, const glm::mat4& inverseBind);

    const tinygltf::Model& m_model;
    const SceneNodes& m_scene;
    std::vector<Bone>& m_bones;
    std::vector<char> m_mirrors; ///< one a bone
    bool m_isOverfull = false;
    std::map<int, std::vector<std::uint16_t>> m_ofSkin;
    std::map<Key, std::uint16_t> m_known; ///< node and the bits of its matrix
};

} // namespace crowd::model::gltf
