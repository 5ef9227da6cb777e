// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include <QtTest/QTest>

#include "model/base/Color.h"
#include "render/style/Style.h"
#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

/// What becomes of light on its way to the picture: corners, air, exposure.
class TestAirAndTone : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { open(); }
    void cleanupTestCase() { m_renderer->destroy(); }
    void hazeHidesWhatIsFar();
    void hazeCanLieLow();
    void aStopDoublesTheLight();
    void whiteIsWhatIsSaid();
    void filmKeepsHighlights();
    void thePlainLookKnowsNoneOfIt();
    void cornersAreDarker_data();
    void cornersAreDarker();
    void beamsAreSeenInTheAir();

private:
    [[nodiscard]] render::RenderInput ground();
    /// Linear 0..1 of a pixel of a square picture.
    [[nodiscard]] glm::vec3 linearAt(int x, int y) const;
    [[nodiscard]] glm::vec3 middle() const { return linearAt(kPixels / 2, kPixels / 2); }
};

render::RenderInput TestAirAndTone::ground()
{
    render::RenderInput input(above(), *m_keyframes);
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    input.lighting.showGroundGrid = false;
    input.lighting.ground = glm::vec3(0.4F);
    input.lighting.sunColor = glm::vec3(1.0F);
    input.lighting.ambientColor = glm::vec3(1.0F);
    input.lighting.ambientStrength = 0.3F;
    input.lighting.sunStrength = 0.5F;
    return input;
}

glm::vec3 TestAirAndTone::linearAt(int x, int y) const
{
    const std::uint8_t* pixel = &m_pixels[static_cast<std::size_t>((y * kPixels + x) * 4)];
    return model::linearFromSrgb(glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0F);
}

void TestAirAndTone::hazeHidesWhatIsFar()
{
    render::RenderInput input = ground();
    input.lighting.skyHorizon = {1.0F, 0.0F, 0.0F};
    draw(input);
    const glm::vec3 clear = middle();
    input.lighting.haze = 0.9F; // of a hundred metres; the eye is ten away
    draw(input);
    const float hidden = 1.0F - std::pow(0.1F, 0.1F);
    const glm::vec3 wanted = glm::mix(clear, glm::vec3(1.0F, 0.0F, 0.0F), hidden);
    QVERIFY(std::abs(middle().x - wanted.x) < 0.02F && std::abs(middle().y - wanted.y) < 0.02F);
}

/// From above one looks through little of it; before a wall it thins as it should, though a wall
/// has no corners on half its height.
void TestAirAndTone::hazeCanLieLow()
{
    constexpr float kHeight = 2.0F;
    // The mean of exp(-y / height) between two heights, times the way.
    const auto hidden = [](float from, float to, float way) {
        const float rise = (to - from) / kHeight;
        const float mean = (std::exp(-from / kHeight) - std::exp(-to / kHeight)) / rise;
        return 1.0F - std::pow(0.1F, way * mean / 100.0F);
    };
    render::RenderInput input = ground();
    input.lighting.skyHorizon = {1.0F, 0.0F, 0.0F};
    draw(input);
    const glm::vec3 clear = middle();
    input.lighting.haze = 0.9F;
    input.lighting.hazeHeight = kHeight;
    draw(input);
    const float above = glm::mix(clear.x, 1.0F, hidden(10.0F, 0.0F, 10.0F));
    QVERIFY2(std::abs(middle().x - above) < 0.01F, qPrintable(QString::number(middle().x)));

    model::StageEntry wall;
    auto stage = makeSheet({{{-40, 0, -40}, {40, 0, -40}, {40, 40, -40}, {-40, 40, -40}}});
    stage->materials[0].baseColor = {0.0F, 0.0F, 0.0F, 1.0F};
    wall.asset = stage;
    const auto camera = model::Camera::lookingAt({0.0F, 1.0F, 0.0F}, {0.0F, 6.0F, -40.0F});
    input.view = model::View(camera, glm::vec2(kPixels));
    input.stages = {&wall, 1};
    draw(input);
    const float way = glm::length(glm::vec3(0.0F, 5.0F, 40.0F));
    const float wanted = hidden(1.0F, 6.0F, way);
    QVERIFY2(std::abs(middle().x - wanted) < 0.03F,
             qPrintable(QStringLiteral("%1, not %2").arg(middle().x).arg(wanted)));
    QVERIFY(linearAt(kPixels / 2, 4).x < wanted - 0.02F);                // higher up the wall
    QVERIFY(linearAt(kPixels / 2, kPixels * 6 / 10).x > wanted + 0.02F); // lower down
}

void TestAirAndTone::aStopDoublesTheLight()
{
    render::RenderInput input = ground();
    draw(input);
    const float before = middle().y;
    input.lighting.exposureStops = 1.0F;
    draw(input);
    QVERIFY2(std::abs(middle().y / before - 2.0F) < 0.06F, qPrintable(QString::number(before)));
    input.lighting.exposureStops = -1.0F;
    draw(input);
    QVERIFY(std::abs(middle().y / before - 0.5F) < 0.03F);
}

void TestAirAndTone::whiteIsWhatIsSaid()
{
    render::RenderInput input = ground();
    draw(input);
    const float neutral = middle().z / middle().x;
    input.lighting.whiteKelvin = 3200.0F;
    draw(input);
    QVERIFY(middle().z / middle().x > 1.5F * neutral);
    input.lighting.whiteKelvin = 12000.0F;
    draw(input);
    QVERIFY(middle().z / middle().x < 0.8F * neutral);
    model::Lighting lighting;
    QVERIFY(render::Tone::from(lighting).isNeutral());
}

void TestAirAndTone::filmKeepsHighlights()
{
    render::RenderInput input = ground();
    input.lighting.exposureStops = 4.0F;
    draw(input);
    QCOMPARE(middle().y, 1.0F);
    input.lighting.toneMap = model::ToneMap::Filmic;
    draw(input);
    QVERIFY(middle().y < 0.95F && middle().y > 0.5F);
    input.lighting.exposureStops = 0.0F;
    draw(input);
    const float film = middle().y;
    input.lighting.toneMap = model::ToneMap::None;
    draw(input);
    QVERIFY(std::abs(film - middle().y) < 0.05F); // middle grey stays
}

void TestAirAndTone::thePlainLookKnowsNoneOfIt()
{
    render::RenderInput input = ground();
    input.look = render::Look::Plain;
    draw(input);
    const auto before = m_pixels;
    input.lighting.exposureStops = 2.0F;
    input.lighting.whiteKelvin = 3000.0F;
    input.lighting.toneMap = model::ToneMap::Filmic;
    input.lighting.occlusion = 1.0F;
    draw(input);
    QCOMPARE(m_pixels, before);
}

void TestAirAndTone::cornersAreDarker_data()
{
    QTest::addColumn<int>("samples");
    QTest::newRow("quick") << 0;
    QTest::newRow("smooth") << 4;
}

void TestAirAndTone::cornersAreDarker()
{
    QFETCH(const int, samples);
    model::Camera camera = model::Camera::lookingAt({0.0F, 2.0F, 5.0F}, {0.0F, 0.4F, 0.0F});
    render::RenderInput input = ground();
    input.view = model::View(camera, glm::vec2(kPixels));
    input.frame = frameOf(makeRow(1), {entryFor(m_man)});
    input.samples = samples;
    draw(input);
    const auto without = m_pixels;
    input.lighting.occlusion = 1.0F;
    draw(input);
    QVERIFY(m_pixels != without);
    const auto pixelOf = [&](const glm::vec3& place) {
        const auto at = input.view.project(place).value();
        return glm::ivec2(at.x, at.y);
    };
    const auto lostAt = [&](const glm::vec3& place) {
        const glm::ivec2 at = pixelOf(place);
        const auto index = static_cast<std::size_t>((at.y * kPixels + at.x) * 4 + 1);
        return static_cast<int>(without[index]) - static_cast<int>(m_pixels[index]);
    };
    QVERIFY2(lostAt({0.0F, 0.0F, 0.35F}) > 4, qPrintable(QString::number(lostAt({0, 0, 0.35F}))));
    QVERIFY(std::abs(lostAt({2.0F, 0.0F, 0.5F})) <= 1); // nothing is near
    QCOMPARE(m_pixels[1], without[1]);                  // the sky
    // Half as strong is half as dark, and none is what it was.
    const int whole = lostAt({0.0F, 0.0F, 0.35F});
    input.lighting.occlusion = 0.5F;
    draw(input);
    QVERIFY(lostAt({0.0F, 0.0F, 0.35F}) < whole);
    input.showShadows = false;
    draw(input);
    QVERIFY(std::abs(lostAt({2.0F, 0.0F, 0.5F})) <= 1);
}

void TestAirAndTone::beamsAreSeenInTheAir()
{
    const model::Camera camera = model::Camera::lookingAt({0.0F, 5.0F, 20.0F}, {0.0F, 5.0F, 0.0F});
    render::RenderInput input = ground();
    input.view = model::View(camera, glm::vec2(kPixels));
    input.background = {0.0F, 0.0F, 0.0F, 1.0F};
    input.showGround = false;
    model::Light light;
    light.id = 1;
    light.color = {0, 255, 0};
    light.position = {0.0F, 10.0F, 0.0F};
    light.target = {0.0F, 0.0F, 0.0F};
    light.coneRadians = 0.4F;
    light.strength = 5.0F;
    light.beam = 1.0F;
    input.lights = {&light, 1};
    draw(input);
    QVERIFY(middle().y > 0.02F);
    QCOMPARE(middle().x, 0.0F);
    QCOMPARE(linearAt(8, kPixels / 2).y, 0.0F); // beside it
    light.beam = 0.0F;
    draw(input);
    QCOMPARE(middle().y, 0.0F);
}

CROWD_TEST(TestAirAndTone)
#include "tst_AirAndTone.moc"
