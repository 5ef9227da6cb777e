// SPDX-License-Identifier: MIT
#include "app/pictures/NumberedPictures.h"

#include <QtCore/QFileInfo>

namespace crowd::app {

QString fileForFrame(const QString& pattern, int frame)
{
    QString name = pattern;
    const auto first = name.indexOf(QLatin1Char('#'));
    if (first < 0) {
        return name;
    }
    auto end = first;
    while (end < name.size() && name[end] == QLatin1Char('#')) {
        ++end;
    }
    return name.replace(
        first, end - first,
        QStringLiteral("%1").arg(frame, static_cast<int>(end - first), 10, QLatin1Char('0')));
}

QString numberedPattern(const QString& path)
{
    const QFileInfo file(path);
    if (file.fileName().contains(QLatin1Char('#'))) {
        return path;
    }
    const QString ending = file.suffix().isEmpty() ? QString() : QLatin1Char('.') + file.suffix();
    return path.left(path.size() - ending.size()) + QStringLiteral("_####") + ending;
}

} // namespace crowd::app
