// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "model/base/Result.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Scene.h"
#include "render/Looks.h"

namespace crowd::app {

/// How a picture is drawn, as people ask for it.
struct LookWish
{
    std::string look; ///< of all scenes, or the name of one of the scene's; empty: the camera's
    std::string by;   ///< property that people are coloured by; empty: as the look has it
    /// Of the scene, by name, and empty for its first one; without one, or one without a look, a
    /// picture is lit.
    std::optional<std::string> camera{};
    /// Of the timeline's camera, which goes before; 0: it has none.
    std::optional<model::LookId> directed{};
};

/// The same, understood.
struct ChosenLook
{
    render::Look look = render::Look::Lit;
    std::string property = "template";      ///< of the look "property"
    std::optional<model::LookPreset> own{}; ///< where it is one of the scene's
};

/// `by` alone means the look that shows it. An error names what there is.
[[nodiscard]] model::Result<ChosenLook> chosenLook(const LookWish& wish, const model::Scene& scene);
/// A frame of the scene in the colours of the look.
[[nodiscard]] model::CrowdFramePtr colouredBy(const ChosenLook& look, const model::Scene& scene,
                                              model::CrowdFramePtr frame);

} // namespace crowd::app
