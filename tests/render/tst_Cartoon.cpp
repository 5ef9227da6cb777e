// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <set>
#include <vector>

#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

/// Ink around people and on creases, light in steps.
class TestCartoon : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { open(); }
    void cleanupTestCase() { m_renderer->destroy(); }
    void inkRunsAroundPeople_data();
    void inkRunsAroundPeople();
    void flatGroundHasNoInk();
    void theHorizonHasNoInk_data();
    void theHorizonHasNoInk();
    void creasesHaveInk();
    void lightComesInSteps();
    void theOtherLooksHaveNone();

private:
    [[nodiscard]] render::RenderInput frontOf(const model::Camera& camera, render::Look look);
    [[nodiscard]] int brightness(int x, int y) const
    {
        const std::uint8_t* pixel = &m_pixels[static_cast<std::size_t>((y * kPixels + x) * 4)];
        return pixel[0] + pixel[1] + pixel[2];
    }
    /// Pixels of a row that are as dark as ink.
    [[nodiscard]] int inkIn(int row) const
    {
        int count = 0;
        for (int x = 0; x < kPixels; ++x) {
            count += brightness(x, row) < 260 ? 1 : 0;
        }
        return count;
    }
};

render::RenderInput TestCartoon::frontOf(const model::Camera& camera, render::Look look)
{
    render::RenderInput input(model::View(camera, glm::vec2(kPixels)), *m_keyframes);
    input.frame = frameOf(makeRow(1), {entryFor(m_man)});
    input.lighting.showGroundGrid = false;
    input.lighting.ground = glm::vec3(0.8F);
    input.samples = 0;
    input.look = look;
    return input;
}

void TestCartoon::inkRunsAroundPeople_data()
{
    QTest::addColumn<bool>("isPerspective");
    QTest::newRow("perspective") << true;
    QTest::newRow("parallel") << false;
}

void TestCartoon::inkRunsAroundPeople()
{
    QFETCH(const bool, isPerspective);
    model::Camera camera = model::Camera::lookingAt({0.0F, 1.0F, 5.0F}, {0.0F, 1.0F, 0.0F});
    if (!isPerspective) {
        camera.projection = model::Projection::Orthographic;
        camera.orthographicHeight = 4.0F;
    }
    draw(frontOf(camera, render::Look::Lit));
    const int before = inkIn(kPixels / 2);
    draw(frontOf(camera, render::Look::Cartoon));
    const int lines = inkIn(kPixels / 2) - before;
    QVERIFY2(lines >= 3 && lines <= 24, qPrintable(QString::number(lines)));
}

void TestCartoon::flatGroundHasNoInk()
{
    const model::Camera camera = model::Camera::lookingAt({0.0F, 1.2F, 6.0F}, {0.0F, 0.0F, -4.0F});
    render::RenderInput input = frontOf(camera, render::Look::Cartoon);
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    draw(input);
    for (int row = kPixels - 20; row < kPixels; ++row) {
        QCOMPARE(inkIn(row), 0);
    }
}

void TestCartoon::theHorizonHasNoInk_data()
{
    QTest::addColumn<float>("height");
    QTest::addColumn<float>("roll");
    QTest::newRow("of who stands") << 1.7F << 0.0F;
    QTest::newRow("of who lies") << 0.3F << 0.0F;
    QTest::newRow("of a tower") << 60.0F << 0.0F;
    QTest::newRow("of who leans over") << 1.7F << 0.3F;
}

void TestCartoon::theHorizonHasNoInk()
{
    QFETCH(const float, height);
    QFETCH(const float, roll);
    model::Camera camera = model::Camera::lookingAt({0.0F, height, 9.0F}, {0.0F, height, 0.0F});
    camera.orientation = camera.orientation * glm::angleAxis(roll, glm::vec3(0.0F, 0.0F, 1.0F));
    render::RenderInput input = frontOf(camera, render::Look::Cartoon);
    input.lighting.skyHorizon = glm::vec3(0.8F);
    input.lighting.skyZenith = glm::vec3(0.9F);
    input.showShadows = false;
    input.lighting.highlights = 0.0F;
    auto inked = [this, input](const model::Population& people) mutable {
        input.frame = frameOf(people, {entryFor(m_man)});
        input.ink = render::InkLine{0.0F, {}};
        draw(input);
        const std::vector<std::uint8_t> bare = m_pixels;
        input.ink.reset();
        draw(input);
        int count = 0;
        for (std::size_t at = 0; at < bare.size(); at += 4) {
            count += std::abs(m_pixels[at] - bare[at]) > 2 ? 1 : 0;
        }
        return count;
    };
    QCOMPARE(inked(model::Population()), 0);
    if (height < 10.0F) { // who stands before it keeps his outline
        QVERIFY(inked(makeRow(1)) > 20);
    }
}

void TestCartoon::creasesHaveInk()
{
    auto stage = std::make_shared<model::StageAsset>();
    stage->materials.emplace_back();
    model::StageMesh roof; // two slopes that meet along X
    roof.positions = {{-1, 0.2F, 1}, {1, 0.2F, 1},  {1, 1.2F, 0},
                      {-1, 1.2F, 0}, {1, 0.2F, -1}, {-1, 0.2F, -1}};
    roof.normals.assign(6, glm::vec3(0, 1, 0)); // shaded alike
    roof.uv.assign(6, glm::vec2(0));
    roof.indices = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5};
    for (const glm::vec3& corner : roof.positions) {
        stage->bounds.add(corner);
    }
    stage->meshes.push_back(roof);
    model::StageEntry entry;
    entry.asset = stage;
    model::Camera camera = model::Camera::lookingAt({0.0F, 4.0F, 0.01F}, {0.0F, 0.0F, 0.0F});
    camera.projection = model::Projection::Orthographic;
    camera.orthographicHeight = 1.2F; // within both slopes
    render::RenderInput input = frontOf(camera, render::Look::Cartoon);
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    input.stages = {&entry, 1};
    draw(input);
    const int column = kPixels / 2;
    int darkest = 765;
    for (int y = kPixels / 2 - 4; y <= kPixels / 2 + 4; ++y) {
        darkest = std::min(darkest, brightness(column, y));
    }
    QVERIFY2(darkest < brightness(column, kPixels / 4) * 4 / 5,
             qPrintable(QString::number(darkest)));
}

void TestCartoon::lightComesInSteps()
{
    // Two triangles whose normals turn from towards the sun to away from it.
    auto stage = makeSheet({{{-2, 0.1F, 2}, {2, 0.1F, 2}, {2, 0.1F, -2}, {-2, 0.1F, -2}}});
    stage->meshes[0].normals = {{0, 1, 0}, {0, -1, 0.01F}, {0, -1, 0.01F}, {0, 1, 0}};
    model::StageEntry entry;
    entry.asset = stage;
    const auto valuesOf = [&](render::Look look, bool isTwoTone = false) {
        render::RenderInput input = frontOf(above().camera(), look);
        input.frame = frameOf(model::Population(), {entryFor(m_man)});
        input.stages = {&entry, 1};
        input.isTwoTone = isTwoTone;
        input.lighting.sunElevationRadians = 1.5F;
        draw(input);
        std::set<int> values;
        for (int x = 40; x < 88; ++x) {
            values.insert(brightness(x, kPixels / 2));
        }
        return values.size();
    };
    const std::size_t smooth = valuesOf(render::Look::Lit);
    const std::size_t stepped = valuesOf(render::Look::Cartoon);
    QVERIFY2(stepped * 2 < smooth, qPrintable(QStringLiteral("%1 %2").arg(smooth).arg(stepped)));
    const std::size_t two = valuesOf(render::Look::Cartoon, true);
    QVERIFY2(two < stepped, qPrintable(QStringLiteral("%1 %2").arg(stepped).arg(two)));
    QCOMPARE(valuesOf(render::Look::Lit, true), smooth); // it is the cartoon's alone
}

void TestCartoon::theOtherLooksHaveNone()
{
    const model::Camera camera = model::Camera::lookingAt({0.0F, 1.0F, 5.0F}, {0.0F, 1.0F, 0.0F});
    draw(frontOf(camera, render::Look::Plain));
    const int plain = inkIn(kPixels / 2);
    draw(frontOf(camera, render::Look::Cartoon));
    QVERIFY(inkIn(kPixels / 2) > plain + 2);
}

CROWD_TEST(TestCartoon)
#include "tst_Cartoon.moc"
