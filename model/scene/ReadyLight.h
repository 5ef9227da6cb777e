// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "model/scene/Lighting.h"

namespace crowd::model {

/// The light of a time of day.
struct ReadyLight
{
    const char* key;   ///< in scripts
    const char* label; ///< translation context "Fields"
    Lighting light;
};

/// Noon, afternoon, dusk, overcast, night, studio.
[[nodiscard]] std::span<const ReadyLight> readyLights();
[[nodiscard]] const ReadyLight* findReadyLight(std::string_view key); ///< null: none
/// With the ground that a scene has.
[[nodiscard]] Lighting litAs(const ReadyLight& ready, const Lighting& now);

} // namespace crowd::model
