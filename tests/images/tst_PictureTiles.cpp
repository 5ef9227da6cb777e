// SPDX-License-Identifier: MIT
#include "app/pictures/PictureTiles.h"

#include <algorithm>

#include <QtCore/QTemporaryDir>
#include <QtGui/QImage>
#include <QtTest/QTest>

#include "app/pictures/PictureFile.h"
#include "tests/model/FullDisk.h"
#include "tests/program/Test.h"

using namespace crowd;

/// Pictures that are larger than what is drawn at once: where the parts lie, and the files that
/// take them row by row.
class TestPictureTiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tilesCoverThePictureOnce_data();
    void tilesCoverThePictureOnce();
    void rowsComeBackAsTheyWere_data();
    void rowsComeBackAsTheyWere();
    void wideOnesAreWritten();
    void whatIsTooLargeIsRefusedFirst_data();
    void whatIsTooLargeIsRefusedFirst();
    void nothingStaysOfHalfAPicture();

private:
    QTemporaryDir m_folder;
};

void TestPictureTiles::tilesCoverThePictureOnce_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<int>("count");
    QTest::newRow("one pixel") << QSize(1, 1) << 1;
    QTest::newRow("as large as is drawn at once") << QSize(240, 240) << 1;
    QTest::newRow("a pixel wider") << QSize(241, 100) << 3;
    QTest::newRow("a pixel higher") << QSize(100, 241) << 3;
    QTest::newRow("a line") << QSize(5000, 1) << 42;
    QTest::newRow("both") << QSize(700, 401) << 24;
}

void TestPictureTiles::tilesCoverThePictureOnce()
{
    QFETCH(const QSize, size);
    QFETCH(const int, count);
    const glm::ivec2 picture(size.width(), size.height());
    const auto rows = app::tilesOf(picture, 120);
    std::vector<int> covered(static_cast<std::size_t>(picture.x) *
                             static_cast<std::size_t>(picture.y));
    int tiles = 0;
    for (const app::TileRow& row : rows) {
        for (const app::PictureTile& tile : row) {
            ++tiles;
            QCOMPARE(tile.corner.y, row.front().corner.y);
            QCOMPARE(tile.size.y, row.front().size.y);
            const glm::ivec2 drawnEnd = tile.drawnCorner + tile.drawnSize;
            QVERIFY(tile.drawnCorner.x >= 0 && tile.drawnCorner.y >= 0);
            QVERIFY(drawnEnd.x <= picture.x && drawnEnd.y <= picture.y);
            // Patterns begin at the left, and at the bottom.
            QCOMPARE(tile.drawnCorner.x % app::kTileStep, 0);
            QCOMPARE((picture.y - drawnEnd.y) % app::kTileStep, 0);
            for (int y = tile.corner.y; y < tile.corner.y + tile.size.y; ++y) {
                for (int x = tile.corner.x; x < tile.corner.x + tile.size.x; ++x) {
                    const auto line = static_cast<std::size_t>(y);
                    ++covered[line * static_cast<std::size_t>(picture.x) +
                              static_cast<std::size_t>(x)];
                }
            }
        }
    }
    QCOMPARE(tiles, count);
    QVERIFY(std::ranges::count(covered, 1) == static_cast<std::ptrdiff_t>(covered.size()));
}

namespace {

/// Colours times alpha where that is asked for; all different.
std::vector<std::uint8_t> colourful(glm::ivec2 size, bool isTransparent)
{
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const int alpha = isTransparent ? (x * 37 + y * 5) % 256 : 255;
            for (const int value : {x * 3 + y, x + y * 7, 255 - x}) {
                pixels.push_back(static_cast<std::uint8_t>(std::min(value & 255, alpha)));
            }
            pixels.push_back(static_cast<std::uint8_t>(alpha));
        }
    }
    return pixels;
}

} // namespace

void TestPictureTiles::rowsComeBackAsTheyWere_data()
{
    QTest::addColumn<int>("rowsAtOnce");
    QTest::addColumn<bool>("isTransparent");
    QTest::newRow("all at once") << 50 << false;
    QTest::newRow("some") << 7 << false;
    QTest::newRow("one by one, transparent") << 1 << true;
}

void TestPictureTiles::rowsComeBackAsTheyWere()
{
    QFETCH(const int, rowsAtOnce);
    QFETCH(const bool, isTransparent);
    const glm::ivec2 size(61, 50);
    const auto pixels = colourful(size, isTransparent);
    const QString path = m_folder.filePath(QStringLiteral("rows.png"));
    auto file = app::PictureFile::begin(path, {size, isTransparent});
    QVERIFY2(file, file ? "" : file.error().message.c_str());
    const auto bytes = static_cast<std::size_t>(size.x) * 4;
    for (int y = 0; y < size.y; y += rowsAtOnce) {
        const int rows = std::min(rowsAtOnce, size.y - y);
        QVERIFY(file.value()->add(std::span(pixels).subspan(
            static_cast<std::size_t>(y) * bytes, static_cast<std::size_t>(rows) * bytes)));
    }
    QVERIFY(file.value()->finish());
    const QImage read(path);
    QCOMPARE(read.size(), QSize(size.x, size.y));
    QCOMPARE(read.hasAlphaChannel(), isTransparent);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const std::size_t at =
                (static_cast<std::size_t>(y * size.x) + static_cast<std::size_t>(x)) * 4;
            const QRgb there = read.pixel(x, y);
            QCOMPARE(qAlpha(there), int{pixels[at + 3]});
            if (!isTransparent) {
                QCOMPARE(there, qRgb(pixels[at], pixels[at + 1], pixels[at + 2]));
            } else if (qAlpha(there) > 0) { // without alpha colours are brighter
                QVERIFY(qRed(there) >= pixels[at] && qGreen(there) >= pixels[at + 1]);
            }
        }
    }
}

void TestPictureTiles::wideOnesAreWritten()
{
    const glm::ivec2 size(app::kMostPixelsASide, 2);
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(size.x) * 2 * 4, 9);
    pixels[pixels.size() - 4] = 200; // the last one's red
    const QString path = m_folder.filePath(QStringLiteral("wide.png"));
    QVERIFY(app::writePicture(path, pixels, size));
    const QImage read(path);
    QCOMPARE(read.size(), QSize(size.x, size.y));
    QCOMPARE(qRed(read.pixel(size.x - 1, 1)), 200);
    QCOMPARE(qRed(read.pixel(size.x - 1, 0)), 9);
}

void TestPictureTiles::whatIsTooLargeIsRefusedFirst_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QSize>("size");
    QTest::addColumn<QString>("message");
    QTest::newRow("beyond all") << QStringLiteral("a.png") << QSize(32769, 1)
                                << QStringLiteral("at most 32768 pixels a side, not 32769");
    QTest::newRow("JPEG") << QStringLiteral("a.jpg") << QSize(9, 20000)
                          << QStringLiteral("a JPEG file has at most 16384");
    QTest::newRow("WebP") << QStringLiteral("a.webp") << QSize(16384, 1)
                          << QStringLiteral("a WebP file has at most 16383");
}

void TestPictureTiles::whatIsTooLargeIsRefusedFirst()
{
    QFETCH(const QString, name);
    QFETCH(const QSize, size);
    QFETCH(const QString, message);
    const QTemporaryDir folder;
    const auto file =
        app::PictureFile::begin(folder.filePath(name), {{size.width(), size.height()}, false});
    QVERIFY(!file);
    const QString said = QString::fromStdString(file.error().message);
    QVERIFY2(said.contains(message) && said.contains(name), qPrintable(said));
    QVERIFY(QDir(folder.path()).isEmpty());
}

/// The disk is full, or nobody goes on: the file is as it was.
void TestPictureTiles::nothingStaysOfHalfAPicture()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.png"));
    const glm::ivec2 size(400, 300);
    const auto pixels = colourful(size, false);
    QVERIFY(app::writePicture(path, pixels, size));
    {
        const testing::FullDisk full(2000);
        const auto written = app::writePicture(path, pixels, size);
        QVERIFY(!written);
        QVERIFY2(written.error().message.find("a.png cannot be written") != std::string::npos,
                 written.error().message.c_str());
    }
    {
        const auto file = app::PictureFile::begin(path, {size, false});
        QVERIFY(file && file.value()->add(std::span(pixels).first(400 * 4 * 100)));
    }
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden),
             QStringList{QStringLiteral("a.png")});
    QCOMPARE(QImage(path).size(), QSize(400, 300));
}

CROWD_TEST(TestPictureTiles)
#include "tst_PictureTiles.moc"
