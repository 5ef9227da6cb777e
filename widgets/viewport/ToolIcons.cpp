// SPDX-License-Identifier: MIT
#include "widgets/viewport/ToolIcons.h"

#include <QtCore/QFile>
#include <QtCore/QString>

namespace crowd::widgets {

QIcon toolIcon(ToolId id)
{
    const QString path = QStringLiteral(":/icons/%1.svg").arg(QLatin1String(toolInfo(id).stableId));
    return QFile::exists(path) ? QIcon(path) : QIcon();
}

} // namespace crowd::widgets
