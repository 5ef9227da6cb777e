// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/crowd/CrowdGpu.h"
#include "render/crowd/CrowdView.h"
#include "render/crowd/EarlierRows.h"
#include "render/gl/AovTarget.h"
#include "render/gl/DepthCopy.h"
#include "render/gl/PictureSum.h"
#include "render/gl/PictureTarget.h"
#include "render/passes/BackgroundPass.h"
#include "render/passes/BeamPass.h"
#include "render/passes/BlobPass.h"
#include "render/passes/EdgePass.h"
#include "render/passes/GhostPass.h"
#include "render/passes/InkPass.h"
#include "render/passes/LightShadowPass.h"
#include "render/passes/OcclusionPass.h"
#include "render/passes/OutlinePass.h"
#include "render/passes/OverlayPass.h"
#include "render/passes/PeopleDrawing.h"
#include "render/passes/PeoplePass.h"
#include "render/passes/ShadowPass.h"
#include "render/passes/StagePass.h"

namespace crowd::render {

inline constexpr int kMostReduction = 3;

/// Everything that holds GL names; lives while a context does. What a picture is drawn of, and in
/// which order, is the table in Passes.cpp.
struct Passes
{
    /// Reduced where the card has little room: coarser people, smaller pictures and shadows, and
    /// edges that are not smooth.
    explicit Passes(int reduced = 0) : reduction(reduced) {}

    const int reduction; ///< 0..kMostReduction
    PictureTarget target;
    AovTarget aovs;
    CrowdGpu crowd{reduction}; ///< whoever looks
    CrowdView seen{};          ///< by the camera
    EarlierRows earlier;
    PeopleDrawing peopleDrawing;
    PeoplePass people{peopleDrawing};
    GhostPass ghosts{peopleDrawing};
    BlobPass blobs;
    StagePass stage{reduction};
    ShadowPass shadows{peopleDrawing, stage};
    LightShadowPass lightShadows{peopleDrawing, stage};
    BackgroundPass background;
    DepthCopy depths; ///< of what is solid
    OcclusionPass occlusion;
    InkPass ink;
    BeamPass beams;
    OverlayPass overlay;
    PictureSum sum; ///< of pictures that ripen
    EdgePass edges;
    OutlinePass outline;

    /// Builds the shaders of those that have some from the start.
    [[nodiscard]] model::Result<void> initialize();
    /// Into the target, which has begun.
    [[nodiscard]] model::Result<void> draw(PassContext context);
    /// Places, normals and motion of what is solid; the target stays as it is.
    [[nodiscard]] model::Result<AovPicture> drawAovs(PassContext context);
    /// From the target to a framebuffer, or to the target's own if it is null.
    [[nodiscard]] model::Result<void> finish(const PassContext& context,
                                             const std::uint32_t* framebuffer);

private:
    void prepare(const PassContext& context);
    /// What the light does not reach; the target is bound afterwards.
    [[nodiscard]] model::Result<void> drawShadows(PassContext& context);
};

} // namespace crowd::render
