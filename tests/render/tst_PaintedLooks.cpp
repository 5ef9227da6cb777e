// SPDX-License-Identifier: MIT
#include <cstdlib>

#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

/// Looks that draw everything of a kind in one colour.
class TestPaintedLooks : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { open(); }
    void cleanupTestCase() { m_renderer->destroy(); }
    void materialsDoNotShow_data();
    void materialsDoNotShow();
    void clayIsLit();
    void silhouettesAreDarkOnBright();
    void aBlueprintHasBrightLines();
    void aWireframeIsOfEdges();
    void byPropertyIsInTheColourOfEach();

private:
    [[nodiscard]] render::RenderInput frontOf(render::Look look, bool isColourful = false);
    [[nodiscard]] int brightness(int x, int y) const
    {
        const std::uint8_t* pixel = &m_pixels[static_cast<std::size_t>((y * kPixels + x) * 4)];
        return pixel[0] + pixel[1] + pixel[2];
    }
    model::StageEntry m_wall;
};

/// Somebody before a wall, from two metres high.
render::RenderInput TestPaintedLooks::frontOf(render::Look look, bool isColourful)
{
    const auto camera = model::Camera::lookingAt({0.0F, 2.0F, 6.0F}, {0.0F, 1.0F, 0.0F});
    render::RenderInput input(model::View(camera, glm::vec2(kPixels)), *m_keyframes);
    model::Population people = makeRow(1);
    auto stage = makeSheet({{{-3, 0, -2}, {3, 0, -2}, {3, 1.5F, -2}, {-3, 1.5F, -2}}});
    if (isColourful) {
        setAll(people, model::columns::tint(0), model::Tint{255, 64, 0, 255});
        setAll(people, model::columns::tint(1), model::Tint{0, 200, 0, 255});
        stage->materials[0].baseColor = {0.9F, 0.1F, 0.1F, 1.0F};
        stage->materials[0].emissive = glm::vec3(0.3F);
    }
    m_wall = {};
    m_wall.asset = stage;
    input.stages = {&m_wall, 1};
    input.frame = frameOf(people, {entryFor(m_man)});
    input.samples = 0;
    input.look = look;
    return input;
}

void TestPaintedLooks::materialsDoNotShow_data()
{
    QTest::addColumn<int>("look");
    for (const render::LookInfo& info : render::kLooks) {
        QTest::newRow(info.key) << static_cast<int>(info.look);
    }
}

void TestPaintedLooks::materialsDoNotShow()
{
    QFETCH(const int, look);
    const auto& info = render::lookInfo(static_cast<render::Look>(look));
    draw(frontOf(info.look));
    const std::vector<std::uint8_t> plain = m_pixels;
    draw(frontOf(info.look, true));
    QCOMPARE(m_pixels == plain, info.paint != nullptr && !info.isByProperty);
}

void TestPaintedLooks::clayIsLit()
{
    render::RenderInput input = frontOf(render::Look::Clay);
    draw(input);
    const int lit = brightness(kPixels / 2, kPixels / 2);
    input.lighting.sunStrength = 0.0F;
    input.lighting.ambientStrength = 0.1F;
    draw(input);
    QVERIFY(brightness(kPixels / 2, kPixels / 2) < lit - 60);
}

void TestPaintedLooks::silhouettesAreDarkOnBright()
{
    render::RenderInput input = frontOf(render::Look::Silhouettes);
    draw(input);
    QVERIFY(brightness(kPixels / 2, kPixels / 2) < 120);
    const int wall = brightness(kPixels / 4, kPixels / 2);
    QVERIFY2(wall > 350 && wall < 600, qPrintable(QString::number(wall)));
    QVERIFY(brightness(kPixels / 2, kPixels - 4) > 500); // the ground
    QVERIFY(brightness(kPixels / 2, 4) > 600);           // the sky
    const std::vector<std::uint8_t> day = m_pixels;
    input.lighting.sunStrength = 0.0F;
    draw(input);
    QVERIFY2(m_pixels == day, "it has no light");
}

void TestPaintedLooks::aBlueprintHasBrightLines()
{
    draw(frontOf(render::Look::Blueprint));
    int lines = 0;
    for (int x = 0; x < kPixels; ++x) {
        lines += brightness(x, kPixels / 2) > 550 ? 1 : 0;
    }
    QVERIFY2(lines >= 3 && lines <= 24, qPrintable(QString::number(lines)));
    const std::uint8_t* middle =
        &m_pixels[static_cast<std::size_t>((kPixels / 2 * kPixels + kPixels / 2) * 4)];
    QVERIFY(middle[2] > middle[0] + 60);
}

void TestPaintedLooks::aWireframeIsOfEdges()
{
    const auto different = [this](const render::RenderInput& input) {
        render::RenderInput empty = input;
        empty.frame = frameOf(model::Population(), {entryFor(m_man)});
        draw(empty);
        const std::vector<std::uint8_t> without = m_pixels;
        draw(input);
        int count = 0;
        for (std::size_t i = 0; i < m_pixels.size(); i += 4) {
            count += std::abs(m_pixels[i] - without[i]) > 8 ? 1 : 0;
        }
        return count;
    };
    const int solid = different(frontOf(render::Look::Silhouettes));
    const int wire = different(frontOf(render::Look::Wireframe));
    QVERIFY2(wire > 40 && wire < solid * 3 / 4,
             qPrintable(QStringLiteral("%1 of %2").arg(wire).arg(solid)));
    draw(frontOf(render::Look::Silhouettes)); // and the next picture is solid again
    QVERIFY(brightness(kPixels / 2, kPixels / 2) < 120);
}

/// Whatever people are made of, and however the scene is lit.
void TestPaintedLooks::byPropertyIsInTheColourOfEach()
{
    const auto middleOf = [this](const model::Tint& own, bool isDark) {
        render::RenderInput input = frontOf(render::Look::Property, true);
        auto frame = std::make_shared<model::CrowdFrame>(*input.frame);
        setAll(frame->population, model::columns::tint(0), own);
        input.frame = frame;
        input.lighting.sunStrength = isDark ? 0.0F : 1.0F;
        input.lighting.ambientColor = isDark ? glm::vec3(0.2F, 0.0F, 0.0F) : glm::vec3(1.0F);
        draw(input);
        const std::uint8_t* pixel =
            &m_pixels[static_cast<std::size_t>((kPixels / 2 * kPixels + kPixels / 2) * 4)];
        return glm::ivec3(pixel[0], pixel[1], pixel[2]);
    };
    const glm::ivec3 blue = middleOf({0, 114, 178, 255}, false);
    QVERIFY2(blue.r < 30 && blue.g > 70 && blue.b > blue.g + 30,
             qPrintable(QStringLiteral("%1 %2 %3").arg(blue.r).arg(blue.g).arg(blue.b)));
    const glm::ivec3 orange = middleOf({230, 159, 0, 255}, false);
    QVERIFY(orange.r > orange.g + 30 && orange.b < 30);
    QVERIFY(middleOf({0, 114, 178, 255}, true) == blue);
}

CROWD_TEST(TestPaintedLooks)
#include "tst_PaintedLooks.moc"
