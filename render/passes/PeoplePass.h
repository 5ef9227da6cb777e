// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "model/base/Result.h"
#include "render/crowd/CrowdGpu.h"
#include "render/crowd/CrowdView.h"
#include "render/passes/PassContext.h"
#include "render/passes/PeopleDrawing.h"

namespace crowd::render {

/// Draws the people of a view. Who is highlighted is left in the alpha of the picture, for
/// OutlinePass.
class PeoplePass
{
public:
    explicit PeoplePass(PeopleDrawing& drawing) : m_drawing(drawing) {}

    [[nodiscard]] model::Result<void> draw(const PassContext& context, CrowdGpu& crowd,
                                           const CrowdView& view);
    /// What of people is blended over what is behind them: farthest first.
    [[nodiscard]] model::Result<void> drawSeeThrough(const PassContext& context, CrowdGpu& crowd,
                                                     const CrowdView& view);

private:
    [[nodiscard]] model::Result<void> drawRuns(const PassContext& context, CrowdGpu& crowd,
                                               const GlBuffer& instances,
                                               std::span<const InstanceRun> runs, Surface surface);

    PeopleDrawing& m_drawing;
};

} // namespace crowd::render
