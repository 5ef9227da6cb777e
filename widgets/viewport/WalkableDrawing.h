// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/pick/WalkableGround.h"
#include "render/RenderInput.h"

namespace crowd::widgets {

/// Where people can walk as a colour on the ground. Made anew only when something changed. World
/// frame, metres.
class WalkableDrawing
{
public:
    /// `ground` null: there is none yet, or nothing but open ground.
    [[nodiscard]] std::span<const render::OverlayTriangle>
    areas(const model::WalkableGroundPtr& ground);
    /// Another one for other areas; never 0 once they were asked for.
    [[nodiscard]] std::uint64_t version() const { return m_version; }

private:
    model::WalkableGroundPtr m_ground;
    std::uint64_t m_version = 0;
    std::vector<render::OverlayTriangle> m_areas;
};

} // namespace crowd::widgets
