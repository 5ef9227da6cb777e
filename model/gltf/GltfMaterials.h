// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/gltf/GltfFile.h"
#include "model/template/Template.h"

namespace tinygltf {
class Model;
struct Material;
struct Primitive;
} // namespace tinygltf

/// Materials, their variants and pictures.
namespace crowd::model::gltf {

/// Decodes the pictures that materials ask for, each once. What cannot be decoded becomes a
/// warning, and the material is drawn without it.
class ImageTable
{
public:
    ImageTable(const GltfFile& file, std::vector<Message>& warnings);

    /// Index into images() of the picture of a texture, -1 if there is none to be had.
    int fromTexture(int texture);
    [[nodiscard]] std::vector<Image> take() { return std::move(m_images); }

private:
    int fromImage(int image);
    Result<Image> read(const ImageSource& source);

    const GltfFile& m_file;
    std::vector<Message>& m_warnings;
    std::set<int> m_withoutPicture; ///< textures that were warned of
    std::map<int, int> m_ofFileImage;
    std::vector<Image> m_images;
    std::uint64_t m_encodedBytes = 0;
    std::uint64_t m_pixels = 0;
};

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
