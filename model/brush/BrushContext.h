// SPDX-License-Identifier: MIT
#pragma once

#include "model/bake/KeyframeStore.h"
#include "model/pick/StageRays.h"
#include "model/view/View.h"

namespace crowd::model {

/// What a stroke looks through: the view it is painted in, and what answers questions about it.
/// The referenced objects outlive the stroke; the stage is up to date with the scene.
struct BrushContext
{
    View view;
    KeyframeStore& keyframes;
    const StageRays& stage;
};

} // namespace crowd::model
