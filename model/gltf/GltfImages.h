// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

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
    /// Mean of a texture's picture, which is not kept: its bytes as 0..1. None if there is none to
    /// be had, or no such texture.
    std::optional<glm::vec4> meanOf(int texture);
    [[nodiscard]] std::vector<Image> take() { return std::move(m_images); }

private:
    /// What pictures of a kind have taken so far.
    struct Taken
    {
        std::uint64_t encodedBytes = 0;
        std::uint64_t pixels = 0;
    };

    int fromImage(int image);
    std::optional<glm::vec4> meanOfImage(int image);
    std::optional<Image> readOrWarn(int image, Taken& taken);
    Result<Image> read(const ImageSource& source, Taken& taken);

    const GltfFile& m_file;
    std::vector<Message>& m_warnings;
    std::set<int> m_withoutPicture; ///< textures that were warned of
    std::map<int, int> m_ofFileImage;
    std::vector<Image> m_images;
    std::map<int, std::optional<glm::vec4>> m_means; ///< of images of the file
    Taken m_kept;
    Taken m_passing;
};

} // namespace crowd::model::gltf
