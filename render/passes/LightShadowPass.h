// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/base/Result.h"
#include "render/crowd/CrowdGpu.h"
#include "render/crowd/CrowdView.h"
#include "render/gl/ShadowTarget.h"
#include "render/passes/PassContext.h"
#include "render/passes/PeopleDrawing.h"
#include "render/passes/StagePass.h"
#include "render/passes/StillCasters.h"
#include "render/shadow/LampView.h"

namespace crowd::render {

/// Draws what the lamps see that cast shadows, side by side on one map, which the other passes
/// look at afterwards.
class LightShadowPass
{
public:
    LightShadowPass(PeopleDrawing& people, StagePass& stage) : m_people(people), m_stage(stage) {}

    void initialize();
    [[nodiscard]] static bool isNeeded(const PassContext& context);
    /// Leaves the map's framebuffer bound, and the map at kLightShadowUnit. Where the driver offers
    /// no such map, lights of `context` cast none afterwards.
    [[nodiscard]] model::Result<void> draw(PassContext& context, CrowdGpu& crowd);
    /// Instead of draw(), where none casts.
    void rest() { m_still.rest(); }

private:
    /// Calls `draw` for each view with its part of the map as the viewport.
    template<class Draw>
    [[nodiscard]] model::Result<void> forEachLamp(const Draw& draw) const;
    [[nodiscard]] model::Result<void> drawPeople(const PassContext& casting, CrowdGpu& crowd,
                                                 const LampView& lamp);
    /// All views of those that cast shadows.
    void look(const PassContext& context);
    void tell(PassContext& context) const;

    PeopleDrawing& m_people;
    StagePass& m_stage;
    std::vector<LampView> m_lamps; ///< of this frame, all their views
    int m_pixels = 0;              ///< of the part of a view
    ShadowTarget m_target;
    StillCasters m_still;
    CrowdView m_seen; ///< by one lamp after the other
};

} // namespace crowd::render
