// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "model/base/Result.h"
#include "render/gl/ShadowTarget.h"
#include "render/passes/PassContext.h"

namespace crowd::render {

/// What the stages alone cast on a map, as long as neither they nor those who look change: they are
/// drawn once then. Needs a current context.
class StillCasters
{
public:
    /// Into the map that is bound.
    using DrawStages = std::function<model::Result<void>()>;

    /// Begins the target with them. `views`: of those who look, their clip space from the world.
    /// False: the driver offers no such map.
    [[nodiscard]] model::Result<bool> begin(ShadowTarget& target, int pixels,
                                            const PassContext& context,
                                            std::span<const glm::mat4> views,
                                            const DrawStages& drawStages);
    /// Instead of begin(), where nothing is cast: after a while it lets go of what it kept.
    void rest();

private:
    struct Placed
    {
        model::StagePtr asset;
        glm::mat4 worldFromStage;
        bool operator==(const Placed&) const = default;
    };
    struct Still
    {
        std::vector<glm::mat4> views;
        int pixels = 0;
        std::vector<Placed> stages;
        bool operator==(const Still&) const = default;
    };
    Still m_last;
    bool m_isKept = false; ///< m_kept holds m_last
    int m_framesAtRest = 0;
    ShadowTarget m_kept;
};

} // namespace crowd::render
