// SPDX-License-Identifier: MIT
#pragma once

#include "model/scene/LookPreset.h"
#include "render/Looks.h"
#include "render/RenderInput.h"

namespace crowd::render {

[[nodiscard]] constexpr Look lookOf(model::LookStyle style)
{
    return static_cast<Look>(style);
}

/// Puts into an input what a look of its scene says: the light, what shines, background, ground and
/// lines. Whose colours people have, of "property", is the frame's affair.
void useLook(RenderInput& input, const model::LookPreset& look);

} // namespace crowd::render
