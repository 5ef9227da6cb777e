// SPDX-License-Identifier: MIT
#include "app/pictures/MovieFile.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <unistd.h>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QStringList>

#include "app/pictures/MovieFormats.h"

namespace crowd::app {

namespace {

constexpr int kForever = -1;
constexpr qsizetype kMostSaid = 300; ///< characters of what the encoder says last

QString encoderProgram()
{
    return qEnvironmentVariable("CROWDBRUSH_FFMPEG", QStringLiteral("ffmpeg"));
}

QStringList argumentsOf(const MovieFormat& format, glm::ivec2 size, double framesPerSecond,
                        const QString& path)
{
    QStringList arguments{
        QStringLiteral("-hide_banner"), QStringLiteral("-loglevel"),
        QStringLiteral("error"),        QStringLiteral("-y"),
        QStringLiteral("-f"),           QStringLiteral("rawvideo"),
        QStringLiteral("-pix_fmt"),     QStringLiteral("rgb0"),
        QStringLiteral("-s"),           QStringLiteral("%1x%2").arg(size.x).arg(size.y),
        QStringLiteral("-r"),           QString::number(framesPerSecond, 'g', 12),
        QStringLiteral("-i"),           QStringLiteral("pipe:0")};
    for (const char* argument : format.arguments) {
        arguments << QLatin1String(argument);
    }
    // Nothing in it of when and by whom it was made.
    arguments << QStringLiteral("-fflags") << QStringLiteral("+bitexact")
              << QStringLiteral("-flags:v") << QStringLiteral("+bitexact")
              << QStringLiteral("file:") + path;
    return arguments;
}

} // namespace

MovieFile::MovieFile(const QString& path)
    : m_path(path), m_temporary(QFileInfo(path).absoluteDir().filePath(
                        QStringLiteral(".%1.part").arg(QFileInfo(path).fileName())))
{
}

model::Result<std::unique_ptr<MovieFile>> MovieFile::create(const QString& path, glm::ivec2 size,
                                                            double framesPerSecond)
{
    const MovieFormat* format = movieFormatOf(path);
    if (format == nullptr) {
        return model::Error{
            QT_TRANSLATE_NOOP(
                "Messages",
                "%1: let the name end in one of %2; it says what the movie is written as."),
            path.toStdString(), movieEndings()};
    }
    const QFileInfo target(path);
    if (target.exists() && !target.isFile()) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages", "%1 is no file: give the movie another name."),
            path.toStdString()};
    }
    std::unique_ptr<MovieFile> movie(new MovieFile(path));
    QFile place(movie->m_temporary);
    if (!place.open(QIODevice::WriteOnly)) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages", "%1 cannot be written: %2. Check the folder, its rights "
                                          "and the space on the disk."),
            path.toStdString(), place.errorString().toStdString()};
    }
    place.close();
    movie->m_encoder.setStandardOutputFile(QProcess::nullDevice());
    // Ctrl+C on a terminal is for us alone.
    movie->m_encoder.setChildProcessModifier([] { ::setpgid(0, 0); });
    movie->m_encoder.start(encoderProgram(),
                           argumentsOf(*format, size, framesPerSecond, movie->m_temporary));
    if (!movie->m_encoder.waitForStarted(kForever)) {
        return model::Error{
            QT_TRANSLATE_NOOP(
                "Messages", "%1: movies are made by ffmpeg, which cannot be started (%2). Install "
                            "the package ffmpeg, or write single pictures."),
            path.toStdString(), movie->m_encoder.errorString().toStdString()};
    }
    return movie;
}

MovieFile::~MovieFile()
{
    if (m_encoder.state() != QProcess::NotRunning) {
        m_encoder.kill();
        m_encoder.waitForFinished(kForever);
    }
    if (!m_temporary.isEmpty()) {
        QFile::remove(m_temporary);
    }
}

/// What the encoder said last.
model::Error MovieFile::problem()
{
    m_encoder.closeWriteChannel();
    m_encoder.waitForFinished(kForever);
    QString said = QString::fromLocal8Bit(m_encoder.readAllStandardError()).simplified();
    if (said.isEmpty()) {
        said = m_encoder.errorString();
    }
    return model::Error{
        QT_TRANSLATE_NOOP(
            "Messages", "%1: the movie could not be made, ffmpeg has ended: %2. Check the space on "
                        "the disk, or choose another kind of file."),
        m_path.toStdString(), said.right(kMostSaid).toStdString()};
}

model::Result<void> MovieFile::add(std::span<const std::uint8_t> rgba)
{
    m_encoder.write(reinterpret_cast<const char*>(rgba.data()), static_cast<qint64>(rgba.size()));
    while (m_encoder.bytesToWrite() > 0) {
        if (!m_encoder.waitForBytesWritten(kForever)) {
            return problem();
        }
    }
    return {};
}

model::Result<void> MovieFile::finish()
{
    m_encoder.closeWriteChannel();
    m_encoder.waitForFinished(kForever);
    if (m_encoder.exitStatus() != QProcess::NormalExit || m_encoder.exitCode() != 0) {
        return problem();
    }
    if (std::rename(QFile::encodeName(m_temporary).constData(),
                    QFile::encodeName(QFileInfo(m_path).absoluteFilePath()).constData()) != 0) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages", "%1 cannot be written: %2. Check the folder, its rights "
                                          "and the space on the disk."),
            m_path.toStdString(), std::string(std::strerror(errno))};
    }
    m_temporary.clear();
    return {};
}

} // namespace crowd::app
