// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "app/pictures/PictureFormats.h"

namespace crowd::app {

/// Row by row, so that pictures of any size take no memory; by the PNG library, since Qt's encoder
/// wants them whole.
[[nodiscard]] std::unique_ptr<PictureEncoder> makePngEncoder(const PictureShape& shape,
                                                             ByteSink sink);

} // namespace crowd::app
