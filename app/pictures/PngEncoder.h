// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "app/pictures/PictureFormats.h"

namespace crowd::app {

/// Of pictures, whatever their size.
[[nodiscard]] std::unique_ptr<PictureEncoder> makePngEncoder(const PictureShape& shape,
                                                             ByteSink sink);

} // namespace crowd::app
