// SPDX-License-Identifier: MIT
#include "widgets/viewport/ToolIcons.h"

#include "widgets/theme/Icons.h"

namespace crowd::widgets {

QIcon toolIcon(ToolId id)
{
    return iconNamed(toolInfo(id).stableId);
}

QPixmap toolSymbol(ToolId id, int size, qreal devicePixelRatio)
{
    return iconPixmap(toolInfo(id).stableId, size, QColor(0x20, 0x20, 0x20), devicePixelRatio);
}

} // namespace crowd::widgets
