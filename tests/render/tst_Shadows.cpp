// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <QtTest/QTest>

#include "render/shadow/SunView.h"
#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

constexpr float kQuarter = 1.5707963F;
/// A square of this half size, at a height, facing up.
std::shared_ptr<model::StageAsset> makeSlab(float half, float height)
{
    return makeSheet({{{-half, height, half},
                       {half, height, half},
                       {half, height, -half},
                       {-half, height, -half}}});
}

} // namespace

class TestShadows : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();
    void fallAwayFromTheSun_data();
    void fallAwayFromTheSun();
    void areNoneWhereNoneAreAskedFor();
    void fallOnStagesAndPeople();
    void stagesCastThemToo();
    void everyLevelCastsAlike();
    void areTheSameInEveryFrameAtRest();
    void areSofterUnderALargerSun();
    void somebodyAtTheEndOfTheWorldDoesNotSpoilThem_data();
    void somebodyAtTheEndOfTheWorldDoesNotSpoilThem();
    void theSunSeesWhatTheCameraSees();
    void theSunsStepsAreWholeTexels();
    void theSunSeesNothingBesideTheScene();

private:
    [[nodiscard]] render::RenderInput inputFor(const model::CrowdFramePtr& frame);
    /// Brightness 0..255 of what is at a place of the ground.
    [[nodiscard]] int at(float x, float z) const;
};

void TestShadows::initTestCase()
{
    open();
}

void TestShadows::cleanupTestCase()
{
    m_renderer->destroy();
}

render::RenderInput TestShadows::inputFor(const model::CrowdFramePtr& frame)
{
    render::RenderInput input(above(), *m_keyframes);
    input.frame = frame;
    input.lighting.showGroundGrid = false;
    input.lighting.sunElevationRadians = kQuarter / 2.0F;
    input.lighting.sunAzimuthRadians = kQuarter; // from +X
    input.lighting.shadowStrength = 1.0F;
    input.lighting.shadowSoftnessRadians = 0.0F;
    return input;
}

int TestShadows::at(float x, float z) const
{
    const auto column = static_cast<std::size_t>(kPixels / 2 + static_cast<int>(x * kPerMetre));
    const auto row = static_cast<std::size_t>(kPixels / 2 + static_cast<int>(z * kPerMetre));
    return m_pixels[(row * kPixels + column) * 4 + 1];
}

void TestShadows::fallAwayFromTheSun_data()
{
    QTest::addColumn<float>("azimuth");
    QTest::addColumn<float>("x"); // a metre and a half away from the sun
    QTest::addColumn<float>("z");
    QTest::newRow("from +Z") << 0.0F << 0.0F << -1.5F;
    QTest::newRow("from +X") << kQuarter << -1.5F << 0.0F;
    QTest::newRow("from -Z") << 2.0F * kQuarter << 0.0F << 1.5F;
    QTest::newRow("from -X") << -kQuarter << 1.5F << 0.0F;
}

void TestShadows::fallAwayFromTheSun()
{
    QFETCH(const float, azimuth);
    QFETCH(const float, x);
    QFETCH(const float, z);
    render::RenderInput input = inputFor(frameOf(makeRow(1), {entryFor(m_man)}));
    input.lighting.sunAzimuthRadians = azimuth;
    draw(input);
    const int lit = at(3.0F, 3.0F);
    QVERIFY2(at(x, z) < lit * 8 / 10, qPrintable(QString::number(at(x, z))));
    QVERIFY(std::abs(at(-x, -z) - lit) <= 2);
    QVERIFY(std::abs(at(1.7F * x, 1.7F * z) - lit) <= 2); // 1.8 m high under 45°: no farther
    // Nobody there who casts it.
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    const auto slab = makeSlab(0.2F, 0.0F);
    model::StageEntry entry;
    entry.asset = slab;
    input.stages = {&entry, 1};
    draw(input);
    QVERIFY(std::abs(at(x, z) - lit) <= 2);
}

void TestShadows::areNoneWhereNoneAreAskedFor()
{
    render::RenderInput input = inputFor(frameOf(makeRow(1), {entryFor(m_man)}));
    draw(input);
    const int dark = at(-1.5F, 0.0F);
    const auto isLit = [&](const auto& change) {
        render::RenderInput other = inputFor(frameOf(makeRow(1), {entryFor(m_man)}));
        change(other);
        draw(other);
        return std::abs(at(-1.5F, 0.0F) - at(3.0F, 3.0F)) <= 2 && at(-1.5F, 0.0F) > dark;
    };
    QVERIFY(isLit([](auto& i) { i.lighting.shadowStrength = 0.0F; }));
    QVERIFY(isLit([](auto& i) { i.showShadows = false; }));
    QVERIFY(isLit([](auto& i) { i.look = render::Look::Plain; }));
    // Below the horizon, and black: nothing to keep out.
    for (const float elevation : {-0.5F, 0.0F}) {
        render::RenderInput low = inputFor(frameOf(makeRow(1), {entryFor(m_man)}));
        low.lighting.sunElevationRadians = elevation;
        draw(low);
        QVERIFY(std::abs(at(-1.5F, 0.0F) - at(3.0F, 3.0F)) <= 2);
    }
}

void TestShadows::fallOnStagesAndPeople()
{
    const auto floor = makeSlab(3.5F, 0.5F);
    model::StageEntry entry;
    entry.asset = floor;
    model::Population people = makeRow(2);
    setAll(people, model::columns::position, glm::vec3(0.0F, 0.5F, 0.0F));
    render::RenderInput input = inputFor(frameOf(people, {entryFor(m_man)}));
    input.stages = {&entry, 1};
    draw(input);
    QVERIFY(at(-1.5F, 0.0F) < at(1.5F, 2.0F) * 8 / 10);
    // A tall one between him and the sun: his hat is dark.
    people = makeRow(1);
    input.frame = frameOf(people, {entryFor(m_man)});
    input.stages = {};
    input.lighting.sunElevationRadians = 0.4F;
    draw(input);
    const int lit = at(0.0F, 0.0F);
    people = makeRow(2); // at x = 0 and 1
    const std::array<model::IndividualId, 1> second{2};
    const std::array<float, 1> tall{1.6F};
    people.setValues(model::columns::height, second, std::span<const float>(tall));
    input.frame = frameOf(people, {entryFor(m_man)});
    draw(input);
    QVERIFY2(at(0.0F, 0.0F) < lit * 9 / 10,
             qPrintable(QStringLiteral("%1 %2").arg(at(0.0F, 0.0F)).arg(lit)));
}

void TestShadows::stagesCastThemToo()
{
    const auto roof = makeSlab(1.0F, 2.0F);
    model::StageEntry entry;
    entry.asset = roof;
    render::RenderInput input = inputFor(nullptr);
    input.stages = {&entry, 1};
    draw(input);
    // Two metres high under 45°: two metres away, between -3 and -1; nobody wanted the roof's own.
    QVERIFY(at(-2.0F, 0.0F) < at(3.0F, 3.0F) * 8 / 10);
    QVERIFY(std::abs(at(-3.5F, 0.0F) - at(3.0F, 3.0F)) <= 2);
}

void TestShadows::everyLevelCastsAlike()
{
    const auto fine = makeBoxMan(model::kMaxLevels);
    render::RenderInput input = inputFor(frameOf(makeRow(1), {entryFor(fine)}));
    input.levels = render::LevelThresholds::fullDetail();
    draw(input);
    const std::vector<std::uint8_t> full = m_pixels;
    input.levels = {{1e6F, 1e6F, 0.0F}, 0.0F}; // the coarsest has no soft dark underfoot
    draw(input);
    QCOMPARE(m_pixels, full); // the coarser levels of this one are copies
}

/// What stages cast is kept from the second frame on, and levels do not depend on those before.
void TestShadows::areTheSameInEveryFrameAtRest()
{
    const auto roof = makeSlab(1.0F, 2.0F);
    model::StageEntry entry;
    entry.asset = roof;
    const auto fine = makeBoxMan(model::kMaxLevels);
    render::RenderInput input = inputFor(frameOf(makeRow(3), {entryFor(fine)}));
    input.stages = {&entry, 1};
    draw(input);
    const std::vector<std::uint8_t> first = m_pixels;
    draw(input);
    QCOMPARE(m_pixels, first);
    render::RenderInput other = input; // somewhere else, and back
    model::Camera camera = above().camera();
    camera.orthographicHeight *= 3.0F;
    other.view = {camera, glm::vec2(kPixels)};
    draw(other);
    QVERIFY(m_pixels != first);
    draw(input);
    QCOMPARE(m_pixels, first);
    entry.position.x = 0.5F; // what is kept is not what is there any more
    draw(input);
    QVERIFY(m_pixels != first);
    entry.position.x = 0.0F;
    draw(input);
    QCOMPARE(m_pixels, first);
}

void TestShadows::areSofterUnderALargerSun()
{
    render::RenderInput input = inputFor(frameOf(makeRow(1), {entryFor(m_man)}));
    const auto greys = [&] {
        int count = 0;
        const int lit = at(3.0F, 3.0F);
        const int dark = at(-1.2F, 0.0F);
        for (float z = -2.0F; z < 2.0F; z += 1.0F / kPerMetre) {
            const int here = at(-1.2F, z);
            count += here > dark + 6 && here < lit - 6 ? 1 : 0;
        }
        return count;
    };
    draw(input);
    const int hard = greys();
    input.lighting.shadowSoftnessRadians = 0.2F;
    draw(input);
    QVERIFY2(greys() > hard + 2, qPrintable(QStringLiteral("%1 %2").arg(hard).arg(greys())));
}

void TestShadows::somebodyAtTheEndOfTheWorldDoesNotSpoilThem_data()
{
    QTest::addColumn<float>("x");
    QTest::addColumn<float>("y");
    QTest::newRow("far away") << 1e6F << 0.0F;
    QTest::newRow("high up") << 50.0F << 1e5F;
    QTest::newRow("who has left") << 0.0F << -1e5F;
    QTest::newRow("nowhere") << std::numeric_limits<float>::quiet_NaN() << 0.0F;
}

void TestShadows::somebodyAtTheEndOfTheWorldDoesNotSpoilThem()
{
    QFETCH(const float, x);
    QFETCH(const float, y);
    render::RenderInput input = inputFor(frameOf(makeRow(1), {entryFor(m_man)}));
    draw(input);
    const int dark = at(-1.2F, 0.0F);
    model::Population people = makeRow(2);
    const std::array<model::IndividualId, 1> second{2};
    const std::array<glm::vec3, 1> there{glm::vec3(x, y, 0.0F)};
    people.setValues(model::columns::position, second, std::span<const glm::vec3>(there));
    input.frame = frameOf(people, {entryFor(m_man)});
    draw(input);
    QVERIFY2(std::abs(at(-1.2F, 0.0F) - dark) <= 2,
             qPrintable(QStringLiteral("%1 %2").arg(at(-1.2F, 0.0F)).arg(dark)));
    QVERIFY(at(3.0F, 3.0F) > dark + 20);
}

void TestShadows::theSunSeesWhatTheCameraSees()
{
    model::Bounds box;
    box.add({-20.0F, 0.0F, -20.0F});
    box.add({20.0F, 3.0F, 20.0F});
    const model::View view(model::Camera::lookingAt({5.0F, 4.0F, 12.0F}, {0.0F, 1.0F, 0.0F}),
                           {640.0F, 360.0F});
    const auto sun =
        render::fitSunView(view, 100.0F, box, glm::normalize(glm::vec3(1.0F, 2.0F, 0.5F)), 1024);
    QVERIFY(sun.has_value());
    int seen = 0;
    for (float x = -20.0F; x <= 20.0F; x += 2.0F) {
        for (float z = -20.0F; z <= 20.0F; z += 2.0F) {
            const auto pixel = view.project({x, 1.0F, z});
            if (!pixel || pixel->x < 0.0F || pixel->x > 640.0F || pixel->y < 0.0F ||
                pixel->y > 360.0F) {
                continue;
            }
            ++seen;
            const glm::vec4 place = sun->mapFromWorld * glm::vec4(x, 1.0F, z, 1.0F);
            QVERIFY(place.x >= 0.0F && place.x <= 1.0F && place.y >= 0.0F && place.y <= 1.0F);
            QVERIFY(place.z > 0.0F && place.z < 1.0F);
        }
    }
    QVERIFY(seen > 20);
    QVERIFY(sun->metres.x < 80.0F); // no more than it needs
}

void TestShadows::theSunsStepsAreWholeTexels()
{
    model::Bounds box;
    box.add({-200.0F, 0.0F, -200.0F});
    box.add({200.0F, 3.0F, 200.0F});
    const glm::vec3 toSun = glm::normalize(glm::vec3(0.3F, 1.0F, 0.2F));
    std::optional<render::SunView> first;
    for (int step = 0; step < 20; ++step) {
        const glm::vec3 eye(0.137F * static_cast<float>(step), 3.0F, 0.0F);
        const model::View view(model::Camera::lookingAt(eye, eye + glm::vec3(0.0F, -0.5F, -1.0F)),
                               {640.0F, 360.0F});
        const auto sun = render::fitSunView(view, 30.0F, box, toSun, 512);
        QVERIFY(sun.has_value());
        if (!first || first->metres != sun->metres) {
            first = sun;
            continue;
        }
        const glm::vec4 here = sun->mapFromWorld * glm::vec4(1.0F, 0.0F, -5.0F, 1.0F);
        const glm::vec4 before = first->mapFromWorld * glm::vec4(1.0F, 0.0F, -5.0F, 1.0F);
        const glm::vec2 texels = glm::vec2(here - before) * 512.0F;
        QVERIFY2(glm::length(texels - glm::round(texels)) < 0.05F,
                 qPrintable(QStringLiteral("%1 %2").arg(texels.x).arg(texels.y)));
    }
}

void TestShadows::theSunSeesNothingBesideTheScene()
{
    const model::View away(model::Camera::lookingAt({0.0F, 2.0F, 50.0F}, {0.0F, 2.0F, 90.0F}),
                           {640.0F, 360.0F});
    model::Bounds box;
    box.add({-20.0F, 0.0F, -20.0F});
    box.add({20.0F, 3.0F, 20.0F});
    QVERIFY(!render::fitSunView(away, 500.0F, box, {0.0F, 1.0F, 0.0F}, 512));
    QVERIFY(!render::fitSunView(away, 500.0F, model::Bounds(), {0.0F, 1.0F, 0.0F}, 512));
    // Right overhead, where a camera has no up of its own.
    const model::View there(model::Camera::lookingAt({0.0F, 2.0F, 50.0F}, {0.0F, 2.0F, 0.0F}),
                            {640.0F, 360.0F});
    const auto noon = render::fitSunView(there, 500.0F, box, {0.0F, 1.0F, 0.0F}, 512);
    QVERIFY(noon && std::isfinite(noon->mapFromWorld[0][0]) && noon->texelMetres > 0.0F);
}

CROWD_TEST(TestShadows)
#include "tst_Shadows.moc"
