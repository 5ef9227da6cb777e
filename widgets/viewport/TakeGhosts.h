// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "render/RenderInput.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// People as they are in another take, where they are elsewhere than what is shown: the nearest as
/// ghosts, each with a line to where he is shown. World frame, metres.
class TakeGhosts
{
public:
    /// `shown`: what is shown, as the session has it.
    void make(EditorState& state, std::span<const model::WorldSeat> seats,
              const model::CrowdFrame& shown);
    [[nodiscard]] std::span<const render::Ghost> ghosts() const { return m_ghosts; }
    [[nodiscard]] std::span<const render::OverlayLine> lines() const { return m_lines; }

private:
    std::vector<render::Ghost> m_ghosts;
    std::vector<render::OverlayLine> m_lines;
};

} // namespace crowd::widgets
