// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "model/base/Bounds.h"
#include "model/base/Result.h"
#include "render/crowd/CrowdGpu.h"
#include "render/crowd/CrowdView.h"
#include "render/gl/ShadowTarget.h"
#include "render/passes/PassContext.h"
#include "render/passes/PeopleDrawing.h"
#include "render/passes/StagePass.h"
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
    /// Instead of draw(), where nothing is cast: after a while it lets go of what it kept.
    void rest();

private:
    [[nodiscard]] std::optional<SunView> sunView(const PassContext& context) const;
    [[nodiscard]] model::Result<void> drawStages(const PassContext& context, const SunView& sun,
                                                 int pixels);
    [[nodiscard]] model::Result<void> drawPeople(const PassContext& context, CrowdGpu& crowd,
                                                 const SunView& sun);

    PeopleDrawing& m_people;
    StagePass& m_stage;
    ShadowTarget m_target;
    /// What the stages alone cast, as long as neither they nor the sun's view change: they are
    /// drawn once then.
    struct StillStages
    {
        struct Placed
        {
            model::StagePtr asset;
            glm::mat4 worldFromStage;
            bool operator==(const Placed&) const = default;
        };
        glm::mat4 clipFromWorld{0.0F};
        int pixels = 0;
        std::vector<Placed> stages;
        bool operator==(const StillStages&) const = default;
    };
    StillStages m_last;
    bool m_isKept = false;   ///< m_kept holds m_last
    bool m_isOffered = true; ///< by the driver
    int m_framesAtRest = 0;
    ShadowTarget m_kept;
    CrowdView m_seen; ///< by the sun
};

} // namespace crowd::render
