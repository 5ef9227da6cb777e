// SPDX-License-Identifier: MIT
#pragma once

#include <QtGui/QIcon>

#include "widgets/state/ToolId.h"

namespace crowd::widgets {

/// The symbol of a tool, as drawn at the cursor and in the palette; dark lines for a light ground.
/// Null when the program was built without its icons.
[[nodiscard]] QIcon toolIcon(ToolId id);

} // namespace crowd::widgets
