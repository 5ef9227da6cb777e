// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/gltf/GltfFile.h"
#include "model/gltf/GltfImages.h"
#include "model/template/Template.h"

namespace tinygltf {
class Model;
struct Material;
struct Primitive;
} // namespace tinygltf

/// Materials and their variants.
namespace crowd::model::gltf {

/// Makes slots of materials: one a material and set of variants, named by extras "slot", else by
/// the material.
class SlotTable
{
public:
    SlotTable(const GltfFile& file, std::vector<Message>& warnings);

    /// Announces a primitive; all are announced before finish().
    void add(const tinygltf::Primitive& primitive);
    /// Makes the slots, in the order of the file's materials.
    void finish();
    [[nodiscard]] int slotOf(const tinygltf::Primitive& primitive) const;
    /// The set of texture coordinates that the pictures of a primitive's material want.
    [[nodiscard]] int texCoordOf(const tinygltf::Primitive& primitive) const;
    [[nodiscard]] std::vector<Slot> takeSlots() { return std::move(m_slots); }
    [[nodiscard]] std::vector<Image> takeImages() { return m_images.take(); }

private:
    /// The material, then pairs of variant and material.
    using Key = std::vector<int>;
    [[nodiscard]] static Key keyOf(const tinygltf::Primitive& primitive);
    [[nodiscard]] Slot makeSlot(const Key& key);
    [[nodiscard]] MaterialChoice makeChoice(int material);
    void addGlow(const tinygltf::Material& material, MaterialChoice& choice);
    void addReliefs();
    void addRelief(const tinygltf::Material& material, MaterialChoice& choice);
    [[nodiscard]] std::string variantName(int variant) const;
    void mergeIntoEarlier(const Key& key, Slot slot);

    const GltfFile& m_file;
    std::vector<Message>& m_warnings;
    ImageTable m_images;
    std::map<Key, int> m_slotOfKey;
    std::map<std::string, std::vector<std::size_t>> m_slotsOfName; ///< of the first few of a name
    std::vector<Slot> m_slots;
};

} // namespace crowd::model::gltf
