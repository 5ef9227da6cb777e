// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "behavior/base/Problem.h"
#include "model/scene/Scene.h"

/// What is wrong with rules as they stand, in the artist's language.
namespace crowd::widgets {

/// What is wrong with a rule, and the way out; empty when it is sound.
[[nodiscard]] QString ruleProblem(const model::Scene& scene, const model::Rule& rule);
/// What came to light while it runs, of a rule as its panel says it.
[[nodiscard]] QString problemText(const model::Scene& scene, const behavior::Problem& problem);

} // namespace crowd::widgets
