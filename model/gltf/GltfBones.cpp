// SPDX-License-Identifier: MIT
#include "model/gltf/GltfBones.h"

#include <cstring>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <tiny_gltf.h>

#include "model/gltf/GltfAccessors.h"
#include "model/gltf/GltfLimits.h"

namespace crowd::model::gltf {

BoneTable::BoneTable(const tinygltf::Model& model, const SceneNodes& scene,
                     std::vector<Bone>& bones)
    : m_model(model), m_scene(scene), m_bones(bones)
{
}

const std::vector<std::uint16_t>& BoneTable::ofSkin(int skin)
{
    const auto [known, isNew] = m_ofSkin.try_emplace(skin);
    if (isNew) {
        known->second = makeSkin(m_model.skins[static_cast<std::size_t>(skin)]);
    }
    return known->second;
}

std::uint16_t BoneTable::ofNode(int node)
{
    return add(node, glm::mat4(1.0F));
}

std::vector<std::uint16_t> BoneTable::makeSkin(const tinygltf::Skin& skin)
{
    FloatArray matrices;
    if (skin.inverseBindMatrices >= 0) {
        matrices = readFloats(m_model, skin.inverseBindMatrices, skin.joints.size());
        replaceNonFinite(matrices.values);
    }
    std::vector<std::uint16_t> bones;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        const int node = m_scene.ofFileNode[static_cast<std::size_t>(skin.joints[i])];
        bones.push_back(
            add(node, i < matrices.count ? glm::make_mat4(matrices.at(i)) : glm::mat4(1.0F)));
    }
    return bones;
}

std::uint16_t BoneTable::add(int node, const glm::mat4& inverseBind)
{
    Key key{node, {}};
    std::memcpy(key.second.data(), glm::value_ptr(inverseBind), sizeof(key.second));
    const auto next = static_cast<std::uint16_t>(m_bones.size());
    if (m_bones.size() >= kMaxBones) {
        const auto found = m_known.find(key);
        m_isOverfull = m_isOverfull || found == m_known.end();
        return found == m_known.end() ? std::uint16_t{0} : found->second;
    }
    const auto [known, isNew] = m_known.try_emplace(key, next);
    if (isNew) {
        m_bones.push_back({node, inverseBind});
        const glm::mat4 rest = m_scene.restWorld[static_cast<std::size_t>(node)] * inverseBind;
        m_mirrors.push_back(glm::determinant(glm::mat3(rest)) < 0.0F ? 1 : 0);
    }
    return known->second;
}

} // namespace crowd::model::gltf
