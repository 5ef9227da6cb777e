// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

#include "model/bake/KeyframeStore.h"
#include "model/base/Result.h"
#include "model/template/Template.h"
#include "model/view/View.h"

namespace crowd::render {

class Renderer;

/// A picture of one template for its swatch: the default clip's first keyframe in three-quarter
/// view, or another moment and angle for a turntable.
struct ThumbnailRequest
{
    model::TemplatePtr asset;
    int size = 96; ///< physical pixels, square
    int clip = -1; ///< -1: the default clip
    float phase = 0.0F;
    float turnRadians = 0.6F;   ///< of the character about its own axis
    glm::vec4 background{0.0F}; ///< sRGB; alpha 0: the sky
    bool showGround = false;    ///< with a grid of metres
};

/// Where the picture is taken from, its size as in the request: for what is drawn over it.
[[nodiscard]] model::View thumbnailView(const ThumbnailRequest& request);

/// RGBA8, sRGB, rows from the top, size × size. Uses the renderer's context, which is current, and
/// its cache of uploaded templates. Does not wait for baking.
[[nodiscard]] model::Result<std::vector<std::uint8_t>>
renderThumbnail(Renderer& renderer, model::KeyframeStore& keyframes,
                const ThumbnailRequest& request);

} // namespace crowd::render
