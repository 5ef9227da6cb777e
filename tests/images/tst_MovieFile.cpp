// SPDX-License-Identifier: MIT
#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "app/pictures/MovieFile.h"
#include "app/pictures/MovieFormats.h"
#include "tests/program/MovieContent.h"
#include "tests/program/Test.h"

using namespace crowd::app;

namespace {

constexpr glm::ivec2 kMovieSize{64, 48};

/// One colour after the other.
std::vector<std::uint8_t> picture(int index, glm::ivec2 size = kMovieSize)
{
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(size.x * size.y) * 4, 255);
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        rgba[i] = static_cast<std::uint8_t>(20 * index);
        rgba[i + 1] = static_cast<std::uint8_t>(200 - 20 * index);
        rgba[i + 2] = 60;
    }
    return rgba;
}

crowd::model::Result<void> make(const QString& path, int pictures, glm::ivec2 size = kMovieSize)
{
    auto movie = MovieFile::create(path, size, 25.0);
    if (!movie) {
        return movie.error();
    }
    for (int i = 0; i < pictures; ++i) {
        if (auto added = movie.value()->add(picture(i, size)); !added) {
            return added;
        }
    }
    return movie.value()->finish();
}

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A program in the place of ffmpeg.
QString script(const QTemporaryDir& folder, const char* text)
{
    const QString path = folder.filePath(QStringLiteral("encoder"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0) {
        qFatal("cannot write a script");
    }
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    return path;
}

QStringList filesIn(const QTemporaryDir& folder)
{
    return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden);
}

} // namespace

class TestMovieFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { qunsetenv("CROWDBRUSH_FFMPEG"); }
    void holdsThePictures_data();
    void holdsThePictures();
    void theSameBytesTwice_data() { holdsThePictures_data(); }
    void theSameBytesTwice();
    void oddSizesAreTaken();
    void nothingStaysOfWhatIsNotFinished();
    void saysWhereFfmpegIsNot();
    void saysWhatFfmpegSaysAtItsEnd();
    void saysWhereNothingCanBeWritten();
};

void TestMovieFile::holdsThePictures_data()
{
    QTest::addColumn<QString>("ending");
    for (const MovieFormat& format : movieFormats()) {
        QTest::newRow(format.name) << QString::fromLatin1(format.ending);
    }
}

void TestMovieFile::holdsThePictures()
{
    QFETCH(const QString, ending);
    const QTemporaryDir folder;
    const QString name = QStringLiteral("a b.") + ending;
    const auto made = make(folder.filePath(name), 8);
    QVERIFY2(made.isOk(), made ? "" : made.error().message.c_str());
    QCOMPARE(filesIn(folder), QStringList{name});
    const std::vector<QByteArray> pictures =
        crowd::testing::picturesOf(folder.filePath(name), kMovieSize.x, kMovieSize.y);
    QCOMPARE(pictures.size(), std::size_t{8});
    constexpr qsizetype kMiddle =
        (qsizetype{kMovieSize.y} / 2 * kMovieSize.x + kMovieSize.x / 2) * 3;
    for (int i = 0; i < 8; ++i) {
        const std::vector<std::uint8_t> wanted = picture(i);
        for (int channel = 0; channel < 3; ++channel) {
            const auto seen =
                static_cast<std::uint8_t>(pictures[static_cast<std::size_t>(i)][kMiddle + channel]);
            const int off = std::abs(seen - wanted[static_cast<std::size_t>(channel)]);
            QVERIFY2(off <= 6,
                     qPrintable(QStringLiteral("%1 %2 %3").arg(i).arg(channel).arg(seen)));
        }
    }
}

void TestMovieFile::theSameBytesTwice()
{
    QFETCH(const QString, ending);
    const QTemporaryDir folder;
    const QString one = folder.filePath(QStringLiteral("one.") + ending);
    const QString other = folder.filePath(QStringLiteral("other.") + ending);
    QVERIFY(make(one, 12).isOk() && make(other, 12).isOk());
    QVERIFY(!bytesOf(one).isEmpty());
    QCOMPARE(bytesOf(one), bytesOf(other));
}

void TestMovieFile::oddSizesAreTaken()
{
    const QTemporaryDir folder;
    for (const MovieFormat& format : movieFormats()) {
        const QString path = folder.filePath(QStringLiteral("odd.") + QLatin1String(format.ending));
        for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(33, 17)}) {
            const auto made = make(path, 2, size);
            QVERIFY2(made.isOk(), made ? "" : made.error().message.c_str());
        }
    }
    // No row and no column is added that is black.
    const auto pictures =
        crowd::testing::picturesOf(folder.filePath(QStringLiteral("odd.mp4")), 32, 16);
    QCOMPARE(pictures.size(), std::size_t{2});
    const auto green = static_cast<std::uint8_t>(pictures.front()[pictures.front().size() - 2]);
    QVERIFY2(green > 180, qPrintable(QString::number(green)));
}

void TestMovieFile::nothingStaysOfWhatIsNotFinished()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.mp4"));
    QFile before(path);
    QVERIFY(before.open(QIODevice::WriteOnly) && before.write("before") == 6);
    before.close();
    {
        auto movie = MovieFile::create(path, kMovieSize, 25.0);
        QVERIFY(movie.isOk());
        QVERIFY(movie.value()->add(picture(0)).isOk());
    }
    QCOMPARE(filesIn(folder), QStringList{QStringLiteral("a.mp4")});
    QCOMPARE(bytesOf(path), QByteArray("before"));
}

void TestMovieFile::saysWhereFfmpegIsNot()
{
    const QTemporaryDir folder;
    qputenv("CROWDBRUSH_FFMPEG", "/nonexistent/ffmpeg");
    const auto made = make(folder.filePath(QStringLiteral("a.mp4")), 1);
    QVERIFY(!made && made.error().message.find("Install the package ffmpeg") != std::string::npos);
    QVERIFY(filesIn(folder).isEmpty());
}

/// It dies, at once or after a while, or is killed.
void TestMovieFile::saysWhatFfmpegSaysAtItsEnd()
{
    const QTemporaryDir folder;
    for (const char* text :
         {"#!/bin/sh\necho no room here >&2\nexit 1\n",
          "#!/bin/sh\nhead -c 20000 > /dev/null\necho no room here >&2\nexit 1\n",
          "#!/bin/sh\ncat > /dev/null\necho no room here >&2\nexit 1\n",
          "#!/bin/sh\nhead -c 20000 > /dev/null\necho no room here >&2\nkill -9 $$\n"}) {
        const QTemporaryDir programs;
        qputenv("CROWDBRUSH_FFMPEG", script(programs, text).toUtf8());
        const auto made = make(folder.filePath(QStringLiteral("a.mp4")), 60);
        QVERIFY2(!made, text);
        QVERIFY2(made.error().message.find("no room here") != std::string::npos,
                 made.error().message.c_str());
        QVERIFY(filesIn(folder).isEmpty());
    }
}

void TestMovieFile::saysWhereNothingCanBeWritten()
{
    const QTemporaryDir folder;
    const auto nowhere = make(folder.filePath(QStringLiteral("none/a.mp4")), 1);
    QVERIFY(!nowhere &&
            nowhere.error().message.find("none/a.mp4 cannot be written") != std::string::npos);
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("b.mp4")));
    const auto onFolder = make(folder.filePath(QStringLiteral("b.mp4")), 1);
    QVERIFY(!onFolder && onFolder.error().message.find("is no file") != std::string::npos);
    const auto kind = make(folder.filePath(QStringLiteral("a.avi")), 1);
    QVERIFY(!kind && kind.error().message.find(".mp4, .webm, .gif") != std::string::npos);
}

CROWD_TEST(TestMovieFile)
#include "tst_MovieFile.moc"
