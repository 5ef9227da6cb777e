// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "model/base/Message.h"
#include "model/base/Result.h"
#include "model/gltf/GltfFile.h"
#include "model/template/Template.h"

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

} // namespace crowd::model::gltf
