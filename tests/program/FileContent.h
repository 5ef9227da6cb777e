// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QByteArray>
#include <QtCore/QFile>
#include <QtCore/QString>

namespace crowd::testing {

/// All bytes of a file; words instead where there is none, so that two such are told from content.
inline QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : "(not there: " + path.toUtf8() + ")";
}

} // namespace crowd::testing
