// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <QtTest/QTest>

#include "app/commands/PictureQuality.h"
#include "tests/program/Test.h"

using namespace crowd;

namespace {

constexpr glm::ivec2 kQualitySize{40, 24};

/// Upright stripes of grey, some pixels wide.
std::vector<std::uint8_t> stripes(int width, int dark, int bright)
{
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < kQualitySize.y; ++y) {
        for (int x = 0; x < kQualitySize.x; ++x) {
            const auto grey = static_cast<std::uint8_t>(x / width % 2 == 0 ? dark : bright);
            rgba.insert(rgba.end(), {grey, grey, grey, 255});
        }
    }
    return rgba;
}

} // namespace

/// How near pictures are to each other.
class TestPictureQuality : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSameIsTheBest();
    void noiseIsInDecibels();
    void structureIsWhatCounts();
    void fourPixelsBecomeOne();
};

void TestPictureQuality::theSameIsTheBest()
{
    const auto picture = stripes(3, 40, 200);
    const auto same = app::qualityOf(picture, picture, kQualitySize);
    QCOMPARE(same.psnr, app::kSamePsnr);
    QVERIFY(std::abs(same.ssim - 1.0) < 1e-5);
}

/// All pixels off by 10 of 255: 20 log10(255 / 10).
void TestPictureQuality::noiseIsInDecibels()
{
    const auto off = app::qualityOf(stripes(3, 50, 210), stripes(3, 40, 200), kQualitySize);
    QVERIFY2(std::abs(off.psnr - 28.131) < 0.01, qPrintable(QString::number(off.psnr)));
    QVERIFY(off.ssim > 0.95);
}

/// What is brighter all over is more alike than what has its stripes elsewhere, at the same noise.
void TestPictureQuality::structureIsWhatCounts()
{
    const auto truth = stripes(4, 100, 120);
    const auto brighter = app::qualityOf(stripes(4, 120, 140), truth, kQualitySize);
    const auto turned = app::qualityOf(stripes(4, 120, 100), truth, kQualitySize);
    QVERIFY(std::abs(brighter.psnr - turned.psnr) < 0.01);
    QVERIFY2(brighter.ssim > 0.9, qPrintable(QString::number(brighter.ssim)));
    QVERIFY2(turned.ssim < 0.3, qPrintable(QString::number(turned.ssim)));
}

/// Mixed as light: half of black and white is brighter than the middle of its numbers.
void TestPictureQuality::fourPixelsBecomeOne()
{
    const auto small = app::halved(stripes(1, 0, 255), kQualitySize);
    QCOMPARE(small.size(), std::size_t{20 * 12 * 4});
    QCOMPARE(int{small[0]}, 188);
    QCOMPARE(int{small[3]}, 255);
    const auto same = app::halved(stripes(2, 30, 90), kQualitySize);
    QCOMPARE(int{same[0]}, 30);
    QCOMPARE(int{same[4]}, 90);
}

CROWD_TEST(TestPictureQuality)
#include "tst_PictureQuality.moc"
