// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include <QtCore/QString>
#include <QtCore/QStringList>

#include <glm/vec2.hpp>

#include "app/pictures/ExrFile.h"
#include "app/pictures/PicturePasses.h"
#include "model/base/Result.h"

namespace crowd::app {

/// Passes of one picture, as they go to a file or to several.
struct DrawnPasses
{
    const PicturePasses& passes;
    std::span<const ExrLayer> layers; ///< one each
    const ExrHeader& header;
    std::span<const std::uint8_t> colours; ///< RGBA8 as the renderer leaves it, rows from the top
    bool isTransparent = false;
};

/// An error unless files of that ending hold these passes.
[[nodiscard]] model::Result<void> roomForPasses(const QString& path, const PicturePasses& passes);
/// What is written: one file where its format has layers; else one for each pass, named after it
/// before the ending, but for the colours. Without passes the picture alone.
[[nodiscard]] QStringList passFiles(const QString& path, const PicturePasses& passes);
/// Whether all of them are there already, of that size and whole.
[[nodiscard]] bool arePassesThere(const QString& path, const PicturePasses& passes,
                                  glm::ivec2 size);
/// Each whole or not at all.
[[nodiscard]] model::Result<void> writePasses(const QString& path, const DrawnPasses& drawn);

} // namespace crowd::app
