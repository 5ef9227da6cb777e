// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <QtCore/QString>

#include <glm/vec2.hpp>

#include "app/pictures/ExrFile.h"
#include "model/base/Result.h"

namespace crowd::app {

/// Writes RGBA8 rows from the top to a picture file whose kind its ending tells; whole or not at
/// all. One that is transparent has its colours times alpha, as the renderer leaves them; the alpha
/// of another one says nothing.
[[nodiscard]] model::Result<void> writePicture(const QString& path,
                                               const std::vector<std::uint8_t>& rgba,
                                               glm::ivec2 size, bool isTransparent = false);

/// An error unless files of that ending hold passes.
[[nodiscard]] model::Result<void> roomForPasses(const QString& path);
/// Several layers of one, as OpenEXR, which the path says; whole or not at all.
[[nodiscard]] model::Result<void> writeLayers(const QString& path, const ExrHeader& header,
                                              std::span<const ExrLayer> layers);

} // namespace crowd::app
