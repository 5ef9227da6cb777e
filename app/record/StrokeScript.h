// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "model/brush/Stroke.h"

namespace crowd::app {

/// Strokes as Python: what is set differently since the last stroke of that brush, then the stroke.
/// Run one after the other they set the brushes exactly so, and paint exactly so.
class StrokeScript
{
public:
    /// Not for brushes that scripts bring along: the class would be missing.
    [[nodiscard]] std::string write(const model::RecordedStroke& stroke);

private:
    [[nodiscard]] std::string brush(const model::BrushSettings& settings);

    std::map<model::BrushKind, model::BrushSettings> m_said;
    std::optional<model::Camera> m_camera;
};

} // namespace crowd::app
