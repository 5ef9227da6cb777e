// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <span>

#include <epoxy/gl.h>

#include <QtTest/QTest>

#include "render/gl/GlObjects.h"
#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

using Pixels = std::vector<std::uint8_t>;

double toLinear(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double toEncoded(double linear)
{
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// Of a picture `times` as wide and high, what each pixel has of light.
Pixels shrunk(const Pixels& large, int times)
{
    Pixels small(static_cast<std::size_t>(kPixels) * kPixels * 4);
    for (std::size_t at = 0; at < small.size(); ++at) {
        const int channel = static_cast<int>(at % 4);
        const int x = static_cast<int>(at / 4) % kPixels;
        const int y = static_cast<int>(at / 4) / kPixels;
        double sum = 0.0;
        for (int part = 0; part < times * times; ++part) {
            const int column = x * times + part % times;
            const int row = y * times + part / times;
            sum += toLinear(
                large[static_cast<std::size_t>((row * kPixels * times + column) * 4 + channel)] /
                255.0);
        }
        small[at] =
            static_cast<std::uint8_t>(std::lround(toEncoded(sum / (times * times)) * 255.0));
    }
    return small;
}

/// Root of the mean square of what colours differ by, 0..255.
double differenceOf(const Pixels& one, const Pixels& other)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        const double difference = static_cast<double>(one[i]) - other[i];
        sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(one.size()));
}

/// A sheet whose edges are nowhere along rows of pixels.
model::StageEntry slantedSheet()
{
    model::StageEntry entry;
    entry.id = 1;
    entry.asset = makeSheet({glm::vec3{-2.6F, 0.3F, 1.1F}, glm::vec3{1.7F, 0.3F, 2.9F},
                             glm::vec3{2.6F, 0.3F, -1.3F}, glm::vec3{-1.4F, 0.3F, -2.7F}});
    return entry;
}

} // namespace

/// Edges drawn smooth in the last step, and pictures at rest that ripen.
class TestSmoothEdges : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { m_renderer->destroy(); }
    void edgesComeNearTheTruth();
    void whatIsNoEdgeStays();
    void samplesAndTransparencyAreLeftAlone();
    void whoIsSelectedKeepsTheRim();
    void aPictureRipens();
    void ripeningBeginsAnew();
    void whatMovesDoesNotRipen();
    void aSmallerPictureFillsTheWindow();

private:
    [[nodiscard]] render::RenderInput input();
    void drawRipe(const render::RenderInput& input, int from, int to);
    [[nodiscard]] Pixels truth();

    std::vector<model::StageEntry> m_stages{slantedSheet()};
};

void TestSmoothEdges::initTestCase()
{
    open();
}

render::RenderInput TestSmoothEdges::input()
{
    render::RenderInput input(above(), *m_keyframes);
    input.stages = m_stages;
    input.lighting.showGroundGrid = false;
    input.lighting.ground = glm::vec3(0.2F);
    input.samples = 0;
    return input;
}

/// One after the other, as they ripen.
void TestSmoothEdges::drawRipe(const render::RenderInput& input, int from, int to)
{
    for (int n = from; n < to; ++n) {
        render::RenderInput next = input;
        next.ripeness = n;
        const auto drawn = m_renderer->draw(next);
        QVERIFY2(drawn.isOk(), drawn ? "" : drawn.error().message.c_str());
    }
    m_pixels = m_renderer->readPixels();
}

Pixels TestSmoothEdges::truth()
{
    constexpr int kTimes = 6;
    render::RenderInput large = input();
    large.pixelSize = glm::ivec2(kPixels * kTimes);
    draw(large);
    return shrunk(m_pixels, kTimes);
}

void TestSmoothEdges::edgesComeNearTheTruth()
{
    const Pixels truly = truth();
    draw(input());
    const double rough = differenceOf(m_pixels, truly);
    render::RenderInput smooth = input();
    smooth.smoothsEdges = true;
    draw(smooth);
    const double smoothed = differenceOf(m_pixels, truly);
    QVERIFY2(smoothed < rough * 0.6,
             qPrintable(QStringLiteral("%1 of %2").arg(smoothed).arg(rough)));
}

void TestSmoothEdges::whatIsNoEdgeStays()
{
    render::RenderInput flat = input();
    flat.stages = {};
    draw(flat);
    const Pixels before = m_pixels;
    flat.smoothsEdges = true;
    draw(flat);
    QCOMPARE(m_pixels, before);
}

void TestSmoothEdges::samplesAndTransparencyAreLeftAlone()
{
    for (const bool isTransparent : {false, true}) {
        render::RenderInput other = input();
        other.samples = isTransparent ? 0 : 4;
        other.isTransparent = isTransparent;
        draw(other);
        const Pixels before = m_pixels;
        other.smoothsEdges = true;
        draw(other);
        QCOMPARE(m_pixels, before);
    }
}

void TestSmoothEdges::whoIsSelectedKeepsTheRim()
{
    const std::vector<model::IndividualId> chosen{1};
    render::RenderInput one = input();
    one.frame = frameOf(makeRow(1), {entryFor(m_man)});
    const auto orange = [this] {
        int count = 0;
        for (std::size_t i = 0; i < m_pixels.size(); i += 4) {
            count += m_pixels[i] > 230 && m_pixels[i + 1] < 190 && m_pixels[i + 2] < 80 ? 1 : 0;
        }
        return count;
    };
    one.selected = chosen;
    draw(one);
    const int rough = orange();
    one.smoothsEdges = true;
    draw(one);
    QVERIFY(rough > 10);
    QVERIFY2(orange() > rough / 2, qPrintable(QStringLiteral("%1 of %2").arg(orange()).arg(rough)));
}

void TestSmoothEdges::aPictureRipens()
{
    const Pixels truly = truth();
    draw(input());
    const double rough = differenceOf(m_pixels, truly);
    drawRipe(input(), 0, 1);
    QCOMPARE(differenceOf(m_pixels, truly), rough); // the first is a picture as any
    drawRipe(input(), 1, 8);
    const double ripe = differenceOf(m_pixels, truly);
    QVERIFY2(ripe < rough * 0.4, qPrintable(QStringLiteral("%1 of %2").arg(ripe).arg(rough)));
    drawRipe(input(), 8, 16);
    QVERIFY(differenceOf(m_pixels, truly) < ripe);
}

void TestSmoothEdges::ripeningBeginsAnew()
{
    drawRipe(input(), 0, 8);
    const Pixels ripe = m_pixels;
    render::RenderInput other = input();
    other.stages = {};
    drawRipe(other, 0, 3); // something else in between
    drawRipe(input(), 0, 8);
    QCOMPARE(m_pixels, ripe);
    drawRipe(other, 5, 6); // which does not follow the last
    const Pixels alone = m_pixels;
    drawRipe(other, 0, 1);
    QVERIFY(differenceOf(m_pixels, alone) < 0.5); // nothing of the sheet is left in it
    render::RenderInput wider = input();
    wider.pixelSize = {kPixels * 2, kPixels};
    drawRipe(wider, 3, 4); // of another size
    QCOMPARE(m_pixels.size(), static_cast<std::size_t>(kPixels) * kPixels * 8);
}

void TestSmoothEdges::whatMovesDoesNotRipen()
{
    drawRipe(input(), 0, 4);
    render::RenderInput other = input();
    other.stages = {};
    draw(other); // without ripeness
    const Pixels plain = m_pixels;
    drawRipe(other, 0, 1);
    QCOMPARE(m_pixels, plain);
}

void TestSmoothEdges::aSmallerPictureFillsTheWindow()
{
    const render::GlFramebuffer frame = render::GlFramebuffer::create();
    const render::GlTexture texture = render::GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kPixels, kPixels, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 nullptr);
    glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
    render::RenderInput shown = input();
    shown.frame = frameOf(makeRow(1), {entryFor(m_man)});
    const std::vector<model::IndividualId> ids(shown.frame->population.ids().begin(),
                                               shown.frame->population.ids().end());
    for (const bool isSelected : {false, true}) {
        shown.selected = isSelected ? std::span<const model::IndividualId>(ids)
                                    : std::span<const model::IndividualId>();
        shown.smoothsEdges = true;
        shown.pixelSize = glm::ivec2(kPixels);
        draw(shown);
        const Pixels whole = m_pixels;
        shown.pixelSize = glm::ivec2(kPixels / 2);
        shown.framebufferSize = glm::ivec2(kPixels);
        const auto drawn = m_renderer->draw(shown, frame.name());
        QVERIFY2(drawn.isOk(), drawn ? "" : drawn.error().message.c_str());
        Pixels scaled(whole.size());
        glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
        glReadPixels(0, 0, kPixels, kPixels, GL_RGBA, GL_UNSIGNED_BYTE, scaled.data());
        for (std::size_t row = 0; row < kPixels / 2; ++row) { // to rows from the top
            constexpr std::size_t kStride = std::size_t{kPixels} * 4;
            std::swap_ranges(scaled.begin() + static_cast<std::ptrdiff_t>(row * kStride),
                             scaled.begin() + static_cast<std::ptrdiff_t>((row + 1) * kStride),
                             scaled.begin() +
                                 static_cast<std::ptrdiff_t>((kPixels - 1 - row) * kStride));
        }
        const double lost = differenceOf(scaled, whole);
        QVERIFY2(lost > 0.5 && lost < 14.0, qPrintable(QString::number(lost)));
        shown.framebufferSize = glm::ivec2(0);
    }
}

CROWD_TEST(TestSmoothEdges)
#include "tst_SmoothEdges.moc"
