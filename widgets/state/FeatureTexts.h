// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <QtCore/QString>

#include "model/scene/Scene.h"

namespace crowd::widgets {

/// A kind or a value of a feature: those that are ready-made in the artist's language.
[[nodiscard]] QString featureText(const std::string& name);
/// All values of a scene with such names, the kind in brackets behind.
[[nodiscard]] std::vector<model::NamedFeature> featureEntries(const model::Scene& scene);

} // namespace crowd::widgets
