// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "model/brush/Stroke.h"
#include "model/scene/Scene.h"

namespace crowd::app {

/// Strokes as Python: what is set differently since the last stroke of that brush, then the stroke.
/// Run one after the other they set the brushes exactly so, and paint exactly so.
class StrokeScript
{
public:
    /// Not for brushes that scripts bring along: the class would be missing. `scene`: that it was
    /// painted in.
    [[nodiscard]] std::string write(const model::RecordedStroke& stroke, const model::Scene& scene);

private:
    [[nodiscard]] std::string brush(const model::BrushSettings& settings);

    std::map<model::BrushKind, model::BrushSettings> m_said;
    std::optional<model::Camera> m_camera;
};

} // namespace crowd::app
