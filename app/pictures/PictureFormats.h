// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <QtCore/QString>

#include <glm/vec2.hpp>

#include "model/base/Result.h"

namespace crowd::app {

/// What a file has to know of a picture before its pixels.
struct PictureShape
{
    glm::ivec2 size{0};
    bool isTransparent = false; ///< its colours are times alpha; else its alpha says nothing
    bool isDeep = false;        ///< see render::RenderInput
};

/// Takes bytes of a file, in order.
using ByteSink = std::function<model::Result<void>(std::string_view bytes)>;

/// Makes a file's bytes of a picture as the renderer leaves it, rows from the top. The
/// messages say only why there are none, or what its sink said.
class PictureEncoder
{
public:
    PictureEncoder() = default;
    PictureEncoder(const PictureEncoder&) = delete;
    PictureEncoder& operator=(const PictureEncoder&) = delete;
    virtual ~PictureEncoder() = default;

    /// Some whole rows.
    [[nodiscard]] virtual model::Result<void> add(std::span<const std::uint8_t> rows) = 0;
    /// After the last row.
    [[nodiscard]] virtual model::Result<void> finish() = 0;
};

/// Where the passes of a picture go, see PicturePass.
enum class PassRoom : std::uint8_t {
    None,
    Layers,   ///< into the one file
    FilesEach ///< into one file for each
};

/// A kind of file that pictures are written as. The command line, its help, scripts and their
/// messages follow from the table.
struct PictureFormat
{
    const char* name;
    std::span<const char* const> endings; ///< without the dot, lower case; the first is the usual
    bool hasTransparency;
    bool isDeep; ///< has room for colours beyond 8 bits
    PassRoom passes;
    std::string_view end; ///< of whole files; empty: it is not always the same
    int mostPixelsASide;  ///< those that are not written row by row are held in memory twice
    std::unique_ptr<PictureEncoder> (*encoder)(const PictureShape& shape, ByteSink sink);
};

/// Of the formats that take the largest pictures.
inline constexpr int kMostPixelsASide = 32768;

/// The usual one first.
[[nodiscard]] std::span<const PictureFormat> pictureFormats();
/// By the ending of a file's name; null where there is none of that ending.
[[nodiscard]] const PictureFormat* pictureFormatOf(const QString& path);
/// ".png, .jpg, .jpeg".
[[nodiscard]] std::string pictureEndings();

} // namespace crowd::app
