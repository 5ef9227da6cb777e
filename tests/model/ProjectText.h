// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/project/ProjectWriter.h"

namespace crowd::testing {

/// What would be written of a scene, or why nothing would.
inline std::string projectText(const model::Scene& scene)
{
    const auto text = model::projectToText(scene);
    return text ? text.value() : "refused: " + text.error().message;
}

} // namespace crowd::testing
