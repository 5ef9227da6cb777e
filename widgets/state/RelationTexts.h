// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <QtCore/QString>

#include "model/scene/Scene.h"

namespace crowd::widgets {

/// A kind of relation: those that are ready-made in the artist's language.
[[nodiscard]] QString relationText(const std::string& name);
/// All kinds of a scene with such names.
[[nodiscard]] model::RelationKinds relationEntries(const model::Scene& scene);

} // namespace crowd::widgets
