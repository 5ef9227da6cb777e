// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

/// All of it lit alike.
model::StageEntry stageOf(model::StageMesh mesh)
{
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 1, 0));
    mesh.uv.assign(mesh.positions.size(), glm::vec2(0));
    auto stage = std::make_shared<model::StageAsset>();
    stage->materials.emplace_back();
    for (const glm::vec3& corner : mesh.positions) {
        stage->bounds.add(corner);
    }
    stage->meshes.push_back(std::move(mesh));
    model::StageEntry entry;
    entry.asset = stage;
    return entry;
}

} // namespace

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
    void aCrackHasNone_data();
    void aCrackHasNone();
    void aNotchIsFilled();
    void legsHaveInkDownToTheGround();
    void aLowStepOfAFloorHasNoDots();
    void lightComesInSteps();
    void theOtherLooksHaveNone();

private:
    [[nodiscard]] render::RenderInput frontOf(const model::Camera& camera, render::Look look);
    [[nodiscard]] int brightness(int x, int y) const
    {
        const std::uint8_t* pixel = &m_pixels[static_cast<std::size_t>((y * kPixels + x) * 4)];
        return pixel[0] + pixel[1] + pixel[2];
    }
    /// How many pixels ink changes, from a row on downwards.
    [[nodiscard]] int inked(render::RenderInput input, int row = 0)
    {
        input.ink = render::InkLine{0.0F, {}};
        draw(input);
        const std::vector<std::uint8_t> bare = m_pixels;
        input.ink.reset();
        draw(input);
        int count = 0;
        const auto first = static_cast<std::size_t>(row * kPixels) * 4;
        for (std::size_t at = first; at < bare.size(); at += 4) {
            count += std::abs(m_pixels[at] - bare[at]) > 2 ? 1 : 0;
        }
        return count;
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
    const auto inkedWith = [this, &input](const model::Population& people) {
        input.frame = frameOf(people, {entryFor(m_man)});
        return inked(input);
    };
    QCOMPARE(inkedWith(model::Population()), 0);
    if (height < 10.0F) { // who stands before it keeps his outline
        QVERIFY(inkedWith(makeRow(1)) > 20);
    }
}

void TestCartoon::creasesHaveInk()
{
    model::StageMesh roof; // two slopes that meet along X
    roof.positions = {{-1, 0.2F, 1}, {1, 0.2F, 1},  {1, 1.2F, 0},
                      {-1, 1.2F, 0}, {1, 0.2F, -1}, {-1, 0.2F, -1}};
    roof.indices = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5};
    const model::StageEntry entry = stageOf(std::move(roof));
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

void TestCartoon::aCrackHasNone_data()
{
    QTest::addColumn<bool>("isPerspective");
    QTest::addColumn<float>("pixels");
    QTest::addColumn<bool>("hasInk");
    for (const bool isPerspective : {true, false}) {
        const char* name = isPerspective ? "perspective" : "parallel";
        QTest::addRow("%s, a pixel", name) << isPerspective << 1.0F << false;
        QTest::addRow("%s, a gap", name) << isPerspective << 8.0F << true;
    }
}

/// Where two walls do not quite meet; one that can be seen through is one.
void TestCartoon::aCrackHasNone()
{
    QFETCH(const bool, isPerspective);
    QFETCH(const float, pixels);
    QFETCH(const bool, hasInk);
    model::Camera camera = model::Camera::lookingAt({0.0F, 50.0F, 5.0F}, {0.0F, 50.0F, 0.0F});
    if (!isPerspective) {
        camera.projection = model::Projection::Orthographic;
        camera.orthographicHeight = 4.0F;
    }
    render::RenderInput input = frontOf(camera, render::Look::Cartoon);
    const float gap = pixels / input.view.pixelsPerMetre(5.0F);
    model::StageMesh walls; // wider and higher than the picture
    walls.positions = {{-9, 30, 0},  {0, 30, 0}, {0, 70, 0}, {-9, 70, 0},
                       {gap, 30, 0}, {9, 30, 0}, {9, 70, 0}, {gap, 70, 0}};
    walls.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    const model::StageEntry entry = stageOf(std::move(walls));
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    input.stages = {&entry, 1};
    QCOMPARE(inked(input) > 0, hasInk);
}

/// Where an outline has a notch, what is in front goes on above and below: no slope of a floor.
void TestCartoon::aNotchIsFilled()
{
    model::Camera camera = model::Camera::lookingAt({0.0F, 50.0F, 5.0F}, {0.0F, 50.0F, 0.0F});
    camera.projection = model::Projection::Orthographic;
    camera.orthographicHeight = 1.0F;
    render::RenderInput input = frontOf(camera, render::Look::Cartoon);
    const float pixel = 1.0F / static_cast<float>(kPixels);
    const float in = -3.0F * pixel;         // so deep
    const float top = 50.0F + 2.0F * pixel; // and so high
    model::StageMesh walls;                 // one with a notch in its edge, and one far behind
    walls.positions = {{-9, 30, 0},  {0, 30, 0},  {0, 50, 0},   {-9, 50, 0},
                       {-9, 50, 0},  {in, 50, 0}, {in, top, 0}, {-9, top, 0},
                       {-9, top, 0}, {0, top, 0}, {0, 70, 0},   {-9, 70, 0},
                       {-9, 30, -5}, {9, 30, -5}, {9, 70, -5},  {-9, 70, -5}};
    walls.indices = {0, 1, 2,  0, 2,  3,  4,  5,  6,  4,  6,  7,
                     8, 9, 10, 8, 10, 11, 12, 13, 14, 12, 14, 15};
    const model::StageEntry entry = stageOf(std::move(walls));
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    input.stages = {&entry, 1};
    input.ink = render::InkLine{3.0F, {}};
    draw(input);
    for (int row = kPixels / 2 - 2; row < kPixels / 2; ++row) {
        for (int x = kPixels / 2 - 3; x < kPixels / 2; ++x) {
            QVERIFY2(
                brightness(x, row) < 260,
                qPrintable(QStringLiteral("%1, %2: %3").arg(x).arg(row).arg(brightness(x, row))));
        }
    }
}

/// Seen from low down, along a kerb that is not level in the picture.
void TestCartoon::aLowStepOfAFloorHasNoDots()
{
    model::Camera camera = model::Camera::lookingAt({0.0F, 1.5F, 0.0F}, {0.0F, 0.9F, -10.0F});
    camera.orientation = camera.orientation * glm::angleAxis(0.07F, glm::vec3(0.0F, 0.0F, 1.0F));
    render::RenderInput input = frontOf(camera, render::Look::Cartoon);
    input.showShadows = false;
    input.lighting.highlights = 0.0F;
    model::StageMesh kerb; // behind a line lies a floor, a little lower
    kerb.positions = {{-40, 0.2F, 5},   {40, 0.2F, 5},   {40, 0.2F, -6},    {-40, 0.2F, -6},
                      {-40, 0.15F, -6}, {40, 0.15F, -6}, {40, 0.15F, -400}, {-40, 0.15F, -400}};
    kerb.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    const model::StageEntry entry = stageOf(std::move(kerb));
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    input.stages = {&entry, 1};
    input.showGround = false;
    input.background = {0.9F, 0.9F, 0.9F, 1.0F};
    const int dots = inked(input, kPixels * 5 / 8); // the far end of the floor is above
    QVERIFY2(dots == 0, qPrintable(QString::number(dots)));
}

/// Where the floor behind is near, but goes far from pixel to pixel.
void TestCartoon::legsHaveInkDownToTheGround()
{
    render::RenderInput input = frontOf(
        model::Camera::lookingAt({0.0F, 1.2F, 3.0F}, {0.0F, 0.6F, 0.0F}), render::Look::Cartoon);
    input.showShadows = false;
    model::StageMesh post;
    post.positions = {{-40, 0, 12},  {40, 0, 12},  {40, 0, -400}, {-40, 0, -400},
                      {-0.1F, 0, 0}, {0.1F, 0, 0}, {0.1F, 1, 0},  {-0.1F, 1, 0}};
    post.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    const model::StageEntry entry = stageOf(std::move(post));
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    input.stages = {&entry, 1};
    input.showGround = false;
    input.ink = render::InkLine{3.0F, {}};
    draw(input);
    const auto rowOf = [&](float height) {
        return static_cast<int>(input.view.project({0.0F, height, 0.0F})->y);
    };
    for (int row = rowOf(0.6F); row < rowOf(0.16F); ++row) {
        int dark = 0;
        for (int x = 0; x < kPixels; ++x) {
            dark += brightness(x, row) < 500 ? 1 : 0;
        }
        QVERIFY2(dark >= 6, qPrintable(QString::number(row))); // beside it on both sides
    }
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
