// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace crowd::model::gltf {

/// The first so many bytes of a text from a file, for messages; cut between UTF-8 characters.
[[nodiscard]] inline std::string shortened(std::string text, std::size_t bytes)
{
    if (text.size() <= bytes) {
        return text;
    }
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) {
        --bytes; // within a character of several bytes
    }
    text.resize(bytes);
    return text + "...";
}

} // namespace crowd::model::gltf
