// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QByteArray>
#include <QtCore/QProcess>
#include <QtCore/QString>
#include <QtCore/QStringList>

namespace crowd::testing {

/// Pictures of a movie as ffmpeg reads it again, RGB8 of that size.
inline std::vector<QByteArray> picturesOf(const QString& path, int width, int height)
{
    QProcess reader;
    reader.start(QStringLiteral("ffmpeg"),
                 {QStringLiteral("-loglevel"), QStringLiteral("error"), QStringLiteral("-i"), path,
                  QStringLiteral("-f"), QStringLiteral("rawvideo"), QStringLiteral("-pix_fmt"),
                  QStringLiteral("rgb24"), QStringLiteral("pipe:1")});
    reader.waitForFinished(-1);
    const QByteArray pixels = reader.readAllStandardOutput();
    const qsizetype bytes = qsizetype{width} * height * 3;
    std::vector<QByteArray> pictures;
    for (qsizetype at = 0; at + bytes <= pixels.size(); at += bytes) {
        pictures.push_back(pixels.mid(at, bytes));
    }
    return pictures;
}

} // namespace crowd::testing
