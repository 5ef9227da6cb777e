// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "render/crowd/CrowdGpu.h"
#include "render/crowd/CrowdView.h"
#include "render/passes/PassContext.h"
#include "render/passes/PeopleDrawing.h"

namespace crowd::render {

/// Into the shadow map that is bound, whom a light sees: of triangles, or of cards where the
/// picture may have some. `seen` is planned and sent anew.
[[nodiscard]] model::Result<void> drawCasters(const PassContext& context, PeopleDrawing& people,
                                              CrowdGpu& crowd, CrowdView& seen,
                                              const model::View& light);

} // namespace crowd::render
