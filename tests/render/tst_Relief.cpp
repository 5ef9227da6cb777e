// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include <QtTest/QTest>

#include "render/style/LinearLight.h"
#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

constexpr float kRightAngle = 1.5707963F;
constexpr std::uint8_t kLevel = 128;
constexpr std::uint8_t kTilted = 218; ///< some 45 degrees

/// A floor of eight metres whose normal map leans the same way everywhere; u to the right (+X), v
/// down in the picture (+Z).
std::shared_ptr<model::StageAsset> leaningFloor(std::uint8_t red, std::uint8_t green)
{
    auto sheet = makeSheet({{{-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4}}});
    sheet->meshes[0].uv = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    sheet->images = {{"leaning", 1, 1, {red, green, kTilted, 255}}};
    model::MaterialChoice& material = sheet->materials[0];
    material.baseColor = {0.5F, 0.5F, 0.5F, 1.0F};
    material.normalImage = 0;
    return sheet;
}

} // namespace

/// Normal maps of stages, by what they do to pictures.
class TestRelief : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { open(); }
    void cleanupTestCase() { m_renderer->destroy(); }
    void leansTowardsTheSunOrAway();
    void flatOnesChangeNothing();
    void theScaleFlattens();
    void lampsAndShadowsKnowIt();
    void looksWithoutMaterialsHaveNone();

private:
    [[nodiscard]] render::RenderInput evening();
    /// How bright the middle of a floor is.
    [[nodiscard]] int drawn(render::RenderInput input,
                            const std::shared_ptr<model::StageAsset>& asset);
};

/// From +X, half way up.
render::RenderInput TestRelief::evening()
{
    render::RenderInput input(above(), *m_keyframes);
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    input.samples = 0;
    input.lighting.showGroundGrid = false;
    input.lighting.sunStrength = 0.6F;
    input.lighting.sunAzimuthRadians = kRightAngle;
    input.lighting.sunElevationRadians = kRightAngle / 2.0F;
    input.lighting.ambientStrength = 0.2F;
    input.lighting.highlights = 0.0F;
    return input;
}

int TestRelief::drawn(render::RenderInput input, const std::shared_ptr<model::StageAsset>& asset)
{
    model::StageEntry entry;
    entry.asset = asset;
    const std::array floor{std::move(entry)};
    input.stages = floor;
    draw(input);
    return m_pixels[(kPixels / 2 * kPixels + kPixels / 2) * 4 + 1];
}

void TestRelief::leansTowardsTheSunOrAway()
{
    render::RenderInput input = evening();
    const int flat = drawn(input, leaningFloor(kLevel, kLevel));
    const int towards = drawn(input, leaningFloor(kTilted, kLevel)); // red: along u, to the sun
    const int away = drawn(input, leaningFloor(255 - kTilted, kLevel));
    QVERIFY2(towards > flat + 15, qPrintable(QStringLiteral("%1 %2").arg(towards).arg(flat)));
    QVERIFY2(away < flat - 40, qPrintable(QStringLiteral("%1 %2").arg(away).arg(flat)));
    // Green points up in the picture, which is away from us: to -Z.
    input.lighting.sunAzimuthRadians = 2.0F * kRightAngle;
    const bool isSunBehind = drawn(input, leaningFloor(kLevel, kTilted)) > flat;
    input.lighting.sunAzimuthRadians = 0.0F;
    const bool isSunBefore = drawn(input, leaningFloor(kLevel, kTilted)) > flat;
    QVERIFY(isSunBehind != isSunBefore);
    const glm::vec3 sun = render::LinearLight::from(input.lighting).sunDirection;
    QCOMPARE(isSunBefore, sun.z < 0.0F);
}

void TestRelief::flatOnesChangeNothing()
{
    const auto plain = leaningFloor(kLevel, kLevel);
    auto without = leaningFloor(kLevel, kLevel);
    without->materials[0].normalImage = -1;
    for (const float highlights : {0.0F, 1.0F}) {
        render::RenderInput input = evening();
        input.lighting.highlights = highlights;
        const int wanted = drawn(input, without);
        QVERIFY(std::abs(drawn(input, plain) - wanted) <= 1);
    }
}

void TestRelief::theScaleFlattens()
{
    const auto leaning = leaningFloor(255 - kTilted, kLevel);
    const int steep = drawn(evening(), leaning);
    auto less = leaningFloor(255 - kTilted, kLevel);
    less->materials[0].normalScale = 0.3F;
    const int gentle = drawn(evening(), less);
    QVERIFY(gentle > steep + 20);
    auto none = leaningFloor(255 - kTilted, kLevel);
    none->materials[0].normalScale = 0.0F;
    QVERIFY(drawn(evening(), none) > gentle + 5);
}

void TestRelief::lampsAndShadowsKnowIt()
{
    // A lamp at -X, where the floor leans to.
    render::RenderInput input = evening();
    input.lighting.sunStrength = 0.0F;
    model::Light lamp = model::newLight(model::LightKind::Point, {-3.0F, 0.0F, 0.0F}, {});
    lamp.id = 1;
    lamp.position = {-3.0F, 2.0F, 0.0F};
    lamp.strength = 3.0F;
    const std::array lamps{lamp};
    input.lights = lamps;
    const int towards = drawn(input, leaningFloor(255 - kTilted, kLevel));
    const int away = drawn(input, leaningFloor(kTilted, kLevel));
    QVERIFY2(towards > away + 30, qPrintable(QStringLiteral("%1 %2").arg(towards).arg(away)));
    // With the sun's shadows on, nothing that is lit gets darker.
    render::RenderInput shadowed = evening();
    const int lit = drawn(shadowed, leaningFloor(kTilted, kLevel));
    shadowed.showShadows = true;
    shadowed.lighting.shadowStrength = 1.0F;
    QVERIFY(std::abs(drawn(shadowed, leaningFloor(kTilted, kLevel)) - lit) <= 2);
}

void TestRelief::looksWithoutMaterialsHaveNone()
{
    for (const render::Look look : {render::Look::Plain, render::Look::Clay, render::Look::Cartoon,
                                    render::Look::Silhouettes}) {
        render::RenderInput input = evening();
        input.look = look;
        QCOMPARE(drawn(input, leaningFloor(kTilted, kLevel)),
                 drawn(input, leaningFloor(kLevel, kLevel)));
    }
}

CROWD_TEST(TestRelief)
#include "tst_Relief.moc"
