// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/view/View.h"
#include "render/RenderInput.h"

namespace crowd::widgets {

/// A target on the ground, of the same size from anywhere. Metres, world frame.
void addPointMark(std::vector<render::OverlayLine>& lines, const glm::vec3& at,
                  const model::Camera& camera);

} // namespace crowd::widgets
