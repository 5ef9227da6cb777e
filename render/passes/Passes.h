// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/gl/PictureTarget.h"
#include "render/passes/BackgroundPass.h"
#include "render/passes/CrowdPass.h"
#include "render/passes/OutlinePass.h"
#include "render/passes/OverlayPass.h"
#include "render/passes/StagePass.h"

namespace crowd::render {

/// Everything that holds GL names; lives while a context does. What a picture is drawn of, and in
/// which order, is the table in Passes.cpp.
struct Passes
{
    PictureTarget target;
    CrowdPass crowd;
    StagePass stage;
    BackgroundPass background;
    OverlayPass overlay;
    OutlinePass outline;

    /// Builds the shaders of those that have some from the start.
    [[nodiscard]] model::Result<void> initialize();
    /// Into the target, which has begun; the crowd is prepared.
    [[nodiscard]] model::Result<void> draw(const PassContext& context);
};

} // namespace crowd::render
