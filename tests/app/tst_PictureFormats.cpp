// SPDX-License-Identifier: MIT
#include "app/pictures/PictureFormats.h"

#include <QtCore/QTemporaryDir>
#include <QtGui/QImage>
#include <QtTest/QTest>

#include "app/pictures/PictureFile.h"
#include "tests/program/WindowTest.h"

class TestPictureFormats : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyFormatIsWrittenAndReadBack();
    void unknownEndingsAreNamedWithThoseThatThereAre();
};

void TestPictureFormats::everyFormatIsWrittenAndReadBack()
{
    const QTemporaryDir folder;
    std::vector<std::uint8_t> pixels(64 * 32 * 4, 255);
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        pixels[i] = 200; // one colour, which compression keeps
        pixels[i + 2] = 40;
    }
    const QStringList endings =
        QString::fromStdString(crowd::app::pictureEndings()).split(QStringLiteral(", "));
    QVERIFY(endings.size() >= 4);
    for (const QString& ending : endings) {
        const QString path = folder.filePath(QStringLiteral("picture") + ending);
        QVERIFY(crowd::app::pictureFormatOf(path.toUpper()) != nullptr);
        const auto written = crowd::app::writePicture(path, pixels, {64, 32});
        QVERIFY2(written, written ? "" : written.error().message.c_str());
        if (ending == QLatin1String(".exr")) {
            continue; // which Qt does not read: see tst_PicturePasses
        }
        const QImage read(path);
        QCOMPARE(read.size(), QSize(64, 32));
        const QColor color = read.pixelColor(30, 20);
        QVERIFY2(std::abs(color.red() - 200) < 4 && std::abs(color.blue() - 40) < 4,
                 qPrintable(path + color.name()));
    }
}

void TestPictureFormats::unknownEndingsAreNamedWithThoseThatThereAre()
{
    const QTemporaryDir folder;
    const auto written = crowd::app::writePicture(folder.filePath(QStringLiteral("a.exe")),
                                                  std::vector<std::uint8_t>(4), {1, 1});
    QVERIFY(!written);
    QVERIFY(written.error().message.find(".png, .jpg, .jpeg") != std::string::npos);
}

CROWD_WINDOW_TEST(TestPictureFormats)
#include "tst_PictureFormats.moc"
