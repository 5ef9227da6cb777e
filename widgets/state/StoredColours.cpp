// SPDX-License-Identifier: MIT
#include "widgets/state/StoredColours.h"

#include <QtCore/QSettings>
#include <QtCore/QVariant>

namespace crowd::widgets {

std::vector<QColor> storedColours(const char* key, const QStringList& otherwise)
{
    const QVariant value = QSettings().value(QLatin1String(key));
    std::vector<QColor> colors;
    for (const QString& name : value.isValid() ? value.toStringList() : otherwise) {
        if (const QColor color(name); color.isValid()) {
            colors.push_back(color);
        }
    }
    return colors;
}

void storeColours(const char* key, const std::vector<QColor>& colors)
{
    QStringList names;
    for (const QColor& color : colors) {
        names << color.name();
    }
    QSettings().setValue(QLatin1String(key), names);
}

} // namespace crowd::widgets
