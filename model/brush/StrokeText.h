// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>

#include "model/brush/BrushSettings.h"

namespace crowd::model {

/// Name of a stroke's undo step.
[[nodiscard]] QString strokeText(const BrushSettings& settings, int affected);
/// Name of a move's undo step.
[[nodiscard]] QString moveText(int affected);

} // namespace crowd::model
