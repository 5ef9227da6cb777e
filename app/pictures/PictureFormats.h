// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <QtCore/QByteArray>
#include <QtCore/QString>

#include <glm/vec2.hpp>

#include "model/base/Result.h"

namespace crowd::app {

/// A picture as the renderer leaves it.
struct DrawnPicture
{
    const std::vector<std::uint8_t>& rgba; ///< sRGB, rows from the top
    glm::ivec2 size{0};
    bool isTransparent = false; ///< its colours are times alpha; else its alpha says nothing
};

/// A kind of file that pictures are written as. The command line, its help, scripts and their
/// messages follow from the table.
struct PictureFormat
{
    const char* name;
    std::span<const char* const> endings; ///< without the dot, lower case; the first is the usual
    bool hasTransparency;
    bool hasLayers; ///< room for passes, see PicturePass
    /// The file's bytes; the message says why there are none.
    model::Result<QByteArray> (*encode)(const DrawnPicture& picture);
};

/// The usual one first.
[[nodiscard]] std::span<const PictureFormat> pictureFormats();
/// By the ending of a file's name; null where there is none of that ending.
[[nodiscard]] const PictureFormat* pictureFormatOf(const QString& path);
/// ".png, .jpg, .jpeg".
[[nodiscard]] std::string pictureEndings();

} // namespace crowd::app
