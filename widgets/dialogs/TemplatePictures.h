// SPDX-License-Identifier: MIT
#pragma once

#include <QtGui/QImage>

#include "model/bake/KeyframeStore.h"
#include "render/RenderInput.h"
#include "render/Thumbnail.h"

namespace crowd::widgets {

/// A picture of a template, drawn in a GL context without a window that lives as long as the
/// program. Null when there is no GL. Leaves no context current; main thread.
[[nodiscard]] QImage templatePicture(model::KeyframeStore& keyframes,
                                     const render::ThumbnailRequest& request);

/// The same of a scene, of the size that the input says. `isComplete`: nobody's clip was still
/// being computed.
[[nodiscard]] QImage scenePicture(const render::RenderInput& input, bool& isComplete);

} // namespace crowd::widgets
