// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <utility>

#include <QtTest/QTest>

#include "model/base/Color.h"
#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

constexpr float kSmooth = 0.3F;
constexpr float kQuarterTurn = 1.5707963F;

/// Eight metres wide, on the ground, faces up.
model::StageEntry floorOf(const model::MaterialChoice& material)
{
    auto sheet = makeSheet({{{-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4}}});
    sheet->materials[0] = material;
    model::StageEntry entry;
    entry.asset = sheet;
    return entry;
}

model::MaterialChoice grey(float roughness, float metallic = 0.0F)
{
    model::MaterialChoice material;
    material.baseColor = {0.2F, 0.2F, 0.2F, 1.0F};
    material.roughness = roughness;
    material.metallic = metallic;
    return material;
}

/// Ten metres over the middle, eight metres wide there.
model::View fromAbove()
{
    model::Camera camera = model::Camera::lookingAt({0.0F, 10.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    camera.fovYRadians = 2.0F * std::atan(0.4F);
    return {camera, glm::vec2(kPixels)};
}

} // namespace

/// What smooth surfaces mirror, by what it does to pictures.
class TestHighlights : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { open(); }
    void cleanupTestCase() { m_renderer->destroy(); }
    void theSunIsMirroredWhereItShouldBe();
    void theRoughMirrorNothing();
    void theRougherTheWider();
    void metalMirrorsInItsColour();
    void noneInTheShadow();
    void lampsAreMirroredToo();
    void waterMirrorsTheSkyFromTheSide();
    void glassMirrorsThoughItIsSeenThrough();
    void peopleShine_data();
    void peopleShine();
    void otherLooksHaveNone();

private:
    [[nodiscard]] render::RenderInput day(const model::View& view);
    void drawFloor(render::RenderInput input, const model::MaterialChoice& material);
    /// How bright its middle is without highlights.
    [[nodiscard]] float dullFloor(render::RenderInput input, const model::MaterialChoice& material);
    /// Linear, of a pixel so many metres from the middle as seen from above.
    [[nodiscard]] glm::vec3 at(float x, float z) const;
};

render::RenderInput TestHighlights::day(const model::View& view)
{
    render::RenderInput input(view, *m_keyframes);
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    input.samples = 0;
    input.lighting.showGroundGrid = false;
    input.lighting.sunColor = glm::vec3(1.0F);
    input.lighting.sunStrength = 0.4F;
    input.lighting.sunElevationRadians = kQuarterTurn;
    input.lighting.ambientStrength = 0.2F;
    input.lighting.highlights = 1.0F;
    return input;
}

void TestHighlights::drawFloor(render::RenderInput input, const model::MaterialChoice& material)
{
    const std::array floor{floorOf(material)};
    input.stages = floor;
    draw(input);
}

float TestHighlights::dullFloor(render::RenderInput input, const model::MaterialChoice& material)
{
    input.lighting.highlights = 0.0F;
    drawFloor(std::move(input), material);
    return at(0.0F, 0.0F).y;
}

glm::vec3 TestHighlights::at(float x, float z) const
{
    const auto column = static_cast<std::size_t>(kPixels / 2 + static_cast<int>(x * kPerMetre));
    const auto row = static_cast<std::size_t>(kPixels / 2 + static_cast<int>(z * kPerMetre));
    const std::uint8_t* pixel = &m_pixels[(row * kPixels + column) * 4];
    return model::linearFromSrgb(glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0F);
}

/// Straight below the camera when the sun stands overhead, and aside when it does not.
void TestHighlights::theSunIsMirroredWhereItShouldBe()
{
    render::RenderInput input = day(fromAbove());
    const float dull = dullFloor(input, grey(kSmooth));
    drawFloor(input, grey(kSmooth));
    const float gained = at(0.0F, 0.0F).y - dull;
    QVERIFY2(gained > 0.3F && gained < 0.6F, qPrintable(QString::number(gained)));
    QVERIFY(at(3.5F, 0.0F).y < dull + 0.1F * gained);
    // From +X, so that its mirror picture is three metres to that side.
    input.lighting.sunAzimuthRadians = kQuarterTurn;
    input.lighting.sunElevationRadians = std::atan2(10.0F, 3.0F);
    drawFloor(input, grey(kSmooth));
    QVERIFY(at(3.0F, 0.0F).y > dull + 0.7F * gained);
    QVERIFY(at(-2.0F, 0.0F).y < dull + 0.1F * gained);
    input.lighting.highlights = 0.5F;
    drawFloor(input, grey(kSmooth));
    QVERIFY(at(3.0F, 0.0F).y < dull + 0.6F * gained);
}

/// So files that say nothing of it look as they did.
void TestHighlights::theRoughMirrorNothing()
{
    render::RenderInput input = day(fromAbove());
    drawFloor(input, grey(1.0F));
    const std::vector<std::uint8_t> with = m_pixels;
    input.lighting.highlights = 0.0F;
    drawFloor(input, grey(1.0F));
    QCOMPARE(with, m_pixels);
}

void TestHighlights::theRougherTheWider()
{
    const auto ratio = [this](float roughness) { // of two metres aside to the middle
        const render::RenderInput input = day(fromAbove());
        const float dull = dullFloor(input, grey(roughness));
        drawFloor(input, grey(roughness));
        return (at(2.0F, 0.0F).y - dull) / (at(0.0F, 0.0F).y - dull);
    };
    const float narrow = ratio(0.3F);
    const float wide = ratio(0.5F);
    QVERIFY2(narrow < 0.45F && wide > narrow + 0.2F && wide < 1.0F,
             qPrintable(QStringLiteral("%1, %2").arg(narrow).arg(wide)));
}

void TestHighlights::metalMirrorsInItsColour()
{
    model::MaterialChoice copper = grey(kSmooth, 1.0F);
    copper.baseColor = {0.3F, 0.0F, 0.0F, 1.0F};
    render::RenderInput input = day(fromAbove());
    drawFloor(input, copper);
    QVERIFY(at(0.0F, 0.0F).x > 0.9F);
    QVERIFY2(at(0.0F, 0.0F).z < 0.02F, qPrintable(QString::number(at(0.0F, 0.0F).z)));
    copper.metallic = 0.0F; // as lacquer: white on red
    drawFloor(input, copper);
    QVERIFY(at(0.0F, 0.0F).z > 0.3F);
}

/// The sun stands behind a board; what it mirrors of it is gone with the light.
void TestHighlights::noneInTheShadow()
{
    const auto camera = model::Camera::lookingAt({-7.0F, 7.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    render::RenderInput input = day(model::View(camera, glm::vec2(kPixels)));
    input.lighting.sunAzimuthRadians = kQuarterTurn;
    input.lighting.sunElevationRadians = 0.5F * kQuarterTurn;
    input.lighting.shadowStrength = 1.0F;
    drawFloor(input, grey(kSmooth));
    const float shining = at(0.0F, 0.0F).y;
    model::StageEntry board;
    board.asset = makeSheet({{{2, 3, 2}, {5, 3, 2}, {5, 3, -2}, {2, 3, -2}}});
    const std::array stages{floorOf(grey(kSmooth)), board};
    input.stages = stages;
    draw(input);
    const float hidden = at(0.0F, 0.0F).y;
    input.lighting.highlights = 0.0F;
    draw(input);
    QVERIFY2(shining > hidden + 0.25F, qPrintable(QString::number(shining)));
    QVERIFY2(hidden < at(0.0F, 0.0F).y + 0.02F, qPrintable(QString::number(hidden)));
}

void TestHighlights::lampsAreMirroredToo()
{
    render::RenderInput input = day(fromAbove());
    input.lighting.sunStrength = 0.0F;
    input.lighting.ambientStrength = 0.02F;
    model::Light lamp;
    lamp.id = 1;
    lamp.kind = model::LightKind::Point;
    lamp.color = {255, 255, 255};
    lamp.strength = 0.2F;
    lamp.position = {2.0F, 10.0F, 0.0F}; // as high as the camera: mirrored half way
    input.lights = {&lamp, 1};
    drawFloor(input, grey(1.0F));
    const float dull = at(1.0F, 0.0F).y;
    drawFloor(input, grey(kSmooth));
    QVERIFY2(at(1.0F, 0.0F).y > 2.0F * dull, qPrintable(QString::number(at(1.0F, 0.0F).y)));
    QVERIFY(at(-3.0F, 0.0F).y < 1.3F * dull);
}

/// Straight from above it shows its own colour, from the side the sky's.
void TestHighlights::waterMirrorsTheSkyFromTheSide()
{
    render::RenderInput input = day(fromAbove());
    input.lighting.sunStrength = 0.0F;
    input.lighting.skyHorizon = input.lighting.skyZenith = {0.0F, 0.0F, 1.0F};
    drawFloor(input, grey(0.08F));
    const glm::vec3 above = at(0.0F, 0.0F);
    const auto camera = model::Camera::lookingAt({0.0F, 0.3F, 4.0F}, {0.0F, 0.0F, 0.0F});
    input.view = model::View(camera, glm::vec2(kPixels));
    drawFloor(input, grey(0.08F));
    QVERIFY2(at(0.0F, 0.0F).z > above.z + 0.3F, qPrintable(QString::number(above.z)));
    QVERIFY(std::abs(at(0.0F, 0.0F).y - above.y) < 0.03F);
}

void TestHighlights::glassMirrorsThoughItIsSeenThrough()
{
    model::MaterialChoice glass = grey(kSmooth);
    glass.alphaMode = model::AlphaMode::Blend;
    glass.baseColor.w = 0.3F;
    const render::RenderInput input = day(fromAbove());
    const float without = dullFloor(input, glass);
    drawFloor(input, glass);
    QVERIFY2(at(0.0F, 0.0F).y > without + 0.15F, qPrintable(QString::number(without)));
}

void TestHighlights::peopleShine_data()
{
    QTest::addColumn<bool>("hasPicture");
    QTest::newRow("plain") << false;
    QTest::newRow("textured") << true;
}

/// His hat, from above, with the sun overhead.
void TestHighlights::peopleShine()
{
    QFETCH(const bool, hasPicture);
    const auto hatOf = [&](float roughness, float highlights) {
        const auto man = makeBoxMan();
        model::MaterialChoice& hat = man->slots[2].choices[0];
        hat.roughness = roughness;
        if (hasPicture) {
            man->images.push_back({"white", 1, 1, {255, 255, 255, 255}});
            hat.image = 0;
        }
        render::RenderInput input = day(above());
        input.frame = frameOf(makeRow(1), {entryFor(man)});
        input.lighting.highlights = highlights;
        draw(input);
        return at(0.0F, 0.0F).y;
    };
    const float dull = hatOf(kSmooth, 0.0F);
    QCOMPARE(hatOf(1.0F, 1.0F), dull);
    const float shining = hatOf(kSmooth, 1.0F);
    QVERIFY2(shining > dull + 0.3F, qPrintable(QString::number(shining)));
}

void TestHighlights::otherLooksHaveNone()
{
    for (const render::Look look :
         {render::Look::Plain, render::Look::Cartoon, render::Look::Clay, render::Look::Property}) {
        render::RenderInput input = day(fromAbove());
        input.look = look;
        drawFloor(input, grey(kSmooth));
        const std::vector<std::uint8_t> with = m_pixels;
        input.lighting.highlights = 0.0F;
        drawFloor(input, grey(kSmooth));
        QCOMPARE(with, m_pixels);
    }
}

CROWD_TEST(TestHighlights)
#include "tst_Highlights.moc"
