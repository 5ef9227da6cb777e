// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "app/python/ScriptScene.h"

namespace crowd::app {

/// A stroke as a script asks for it. Points in logical pixels of a view of this size.
struct ScriptStroke
{
    model::BrushSettings settings;
    std::vector<model::PointerInput> inputs; ///< never empty
    std::optional<model::Camera> camera;     ///< the scene's first one without
    glm::vec2 viewSize{1280.0F, 720.0F};
    std::uint64_t seed = 1;
    bool allowsMissing = false; ///< the brush may name what the scene does not have
    /// Whom each dab means, as RecordedStroke has it; none: it selects them itself.
    std::vector<std::vector<model::IndividualId>> selected{};
};

using PaintWork = std::function<void(ScriptStrokeLink& dabs)>;
/// Of brush kind Script: `paint` gets the dabs, on the calling thread; what it throws takes the
/// stroke back and goes on. `keepGoing`: asked on the calling thread, between dabs where the scene
/// is its own, else between moves.
[[nodiscard]] model::Result<model::StrokeOutcome>
paintStroke(ScriptScene& script, const ScriptStroke& stroke, const PaintWork& paint = {},
            const model::KeepGoing& keepGoing = {});

} // namespace crowd::app
