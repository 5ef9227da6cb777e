// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/base/Result.h"
#include "render/crowd/CrowdGpu.h"
#include "render/crowd/CrowdView.h"
#include "render/gl/ShadowTarget.h"
#include "render/passes/PassContext.h"
#include "render/passes/PeopleDrawing.h"
#include "render/passes/StagePass.h"
#include "render/passes/StillCasters.h"
#include "render/shadow/SunView.h"

namespace crowd::render {

/// Draws what the sun sees of crowd and stages into its map, which the other passes look at
/// afterwards.
class ShadowPass
{
public:
    ShadowPass(PeopleDrawing& people, StagePass& stage) : m_people(people), m_stage(stage) {}

    void initialize();
    /// Leaves the map's framebuffer bound, and the map at kShadowUnit. Where nothing receives
    /// shadows, or the driver offers no such map, `context` casts none afterwards.
    [[nodiscard]] model::Result<void> draw(PassContext& context, CrowdGpu& crowd);
    /// Instead of draw(), where nothing is cast.
    void rest() { m_still.rest(); }

private:
    [[nodiscard]] std::optional<SunView> sunView(const PassContext& context) const;
    void tell(PassContext& context, const SunView& sun) const;

    PeopleDrawing& m_people;
    StagePass& m_stage;
    ShadowTarget m_target;
    StillCasters m_still;
    CrowdView m_seen; ///< by the sun
};

} // namespace crowd::render
