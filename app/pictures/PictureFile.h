// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <QtCore/QString>

#include <glm/vec2.hpp>

#include "model/base/Result.h"

namespace crowd::app {

/// Writes RGBA8 rows from the top to a picture file whose kind its ending tells; whole or not at
/// all.
[[nodiscard]] model::Result<void>
writePicture(const QString& path, const std::vector<std::uint8_t>& rgba, glm::ivec2 size);

} // namespace crowd::app
