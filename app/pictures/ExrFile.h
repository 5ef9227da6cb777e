// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <QtCore/QByteArray>
#include <QtCore/QString>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "model/base/Result.h"

namespace crowd::app {

/// One number a pixel, rows from the top.
struct ExrChannel
{
    std::string name; ///< with the layer's: "normal.X"; colours are R, G, B, A
    std::variant<std::vector<float>, std::vector<std::uint32_t>> values;
    bool isHalf = false; ///< in the file, where they are floats
};

/// Channels that are read together: a part of the file.
struct ExrLayer
{
    std::string name;
    std::vector<ExrChannel> channels;
};

/// What the header says beside the layers.
struct ExrHeader
{
    glm::ivec2 size{0};
    std::optional<glm::mat4> cameraFromWorld; ///< and the next: nothing is known of it
    std::optional<glm::mat4> screenFromWorld;
    std::map<std::string, std::string> notes; ///< text by the name of its attribute
};

/// Linear red, green, blue and alpha, of RGBA8, sRGB, colours times alpha where it is transparent;
/// elsewhere its alpha says nothing.
[[nodiscard]] ExrLayer colourLayer(std::span<const std::uint8_t> rgba, bool isTransparent);
/// The same of four half floats a pixel, linear already.
[[nodiscard]] ExrLayer deepColourLayer(std::span<const std::uint8_t> halves, bool isTransparent);

/// The bytes of an OpenEXR file of scan lines: of one part where there is one layer, else of
/// several of the same size. The message says only why there are none.
[[nodiscard]] model::Result<QByteArray> encodeExr(const ExrHeader& header,
                                                  std::span<const ExrLayer> layers);
/// Whether a file is such a one of that size, with all its lines.
[[nodiscard]] bool isWholeExr(const QString& path, glm::ivec2 size);

} // namespace crowd::app
