// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include "app/commands/FrameList.h"
#include "app/commands/RenderCommand.h"
#include "app/pictures/PicturePasses.h"
#include "model/base/Result.h"
#include "render/RenderInput.h"

namespace crowd::app {

/// Options of crowdbrush render as understood.
struct RenderPlan
{
    glm::ivec2 size{1280, 720};
    FrameList frames;
    PicturePasses passes;      ///< empty: a picture as its ending says
    double startSeconds = 0.0; ///< of frame 0
    double framesPerSecond = 30.0;
    bool isMovie = false;   ///< all frames in one file
    bool isResumed = false; ///< pictures that are there stay
    bool isTransparent = false;

    [[nodiscard]] double secondsOf(int frame) const;
    [[nodiscard]] double beginSeconds() const; ///< of the first picture
    /// Of the moment that a picture's motion is said against; its own where that is the beginning.
    [[nodiscard]] double secondsBefore(int frame) const;
    [[nodiscard]] double seconds() const; ///< from the first picture to the end of the last
};

/// An error names the option and what it takes.
[[nodiscard]] model::Result<RenderPlan> planOf(const RenderOptions& options);

} // namespace crowd::app
