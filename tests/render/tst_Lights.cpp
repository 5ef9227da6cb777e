// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

/// From ten metres above a place of the ground, four degrees to each side: 1.4 m wide there.
model::Light spotOn(const glm::vec3& target)
{
    model::Light light;
    light.id = 1;
    light.color = {255, 255, 255};
    light.strength = 0.6F;
    light.position = target + glm::vec3(0.0F, 10.0F, 0.0F);
    light.target = target;
    light.coneRadians = 0.14F;
    light.softness = 0.0F;
    return light;
}

} // namespace

/// A board a metre wide and deep, so high above a place of the ground.
model::StageEntry boardOver(float x, float z, float height)
{
    model::StageEntry entry;
    entry.asset = makeSheet({{{x - 0.5F, height, z + 0.5F},
                              {x + 0.5F, height, z + 0.5F},
                              {x + 0.5F, height, z - 0.5F},
                              {x - 0.5F, height, z - 0.5F}}});
    return entry;
}

/// From the left, 45 degrees high: what is two metres up throws its shadow two to the right.
model::Light slanting(float x, float z)
{
    model::Light light = spotOn({x, 0.0F, z});
    light.position += glm::vec3(-10.0F, 0.0F, 0.0F);
    light.coneRadians = 0.5F;
    light.castsShadows = true;
    return light;
}

/// Lights that stand in the scene, by what they do to pictures.
class TestLights : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { open(); }
    void cleanupTestCase() { m_renderer->destroy(); }
    void aSpotLightsWhatItIsTurnedTo();
    void aPointLightShinesToAllSides();
    void streetLampsGoOnAfterDark();
    void aLargeLampDoesNotBurn();
    void theColourIsTheLights();
    void whatIsOffCostsNoPixel();
    void stagesAndPeopleAreLit();
    void aFollowSpotGoesWithHim();
    void theStrongestShine();
    void whatRulesSayIsSeen();
    void stagesStandInTheLight();
    void peopleStandInTheLight();
    void whatShinesToAllSidesCasts();
    void beamsAreCut();
    void beamsThickenOnTheWay();
    void theStrongestCast();
    void oddOnesDoNoHarm();
    void oddCastersDoNoHarm();
    void aLampInAWallShinesOnlyOutOfIt();
    void aBlackSunIsNoSun();
    void whatIsHiddenIsNotLit();
    void aCameraInsideSomebodySeesOut_data();
    void aCameraInsideSomebodySeesOut();

private:
    [[nodiscard]] render::RenderInput night();
    void shine(render::RenderInput input, std::vector<model::Light> lights);
    [[nodiscard]] glm::ivec3 at(float x, float z) const;
};

render::RenderInput TestLights::night()
{
    render::RenderInput input(above(), *m_keyframes);
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    input.lighting.showGroundGrid = false;
    input.lighting.sunStrength = 0.0F;
    input.lighting.ambientStrength = 0.02F;
    input.lighting.ground = glm::vec3(0.6F);
    return input;
}

void TestLights::shine(render::RenderInput input, std::vector<model::Light> lights)
{
    input.lights = lights;
    draw(input);
}

glm::ivec3 TestLights::at(float x, float z) const
{
    const auto column = static_cast<std::size_t>(kPixels / 2 + static_cast<int>(x * kPerMetre));
    const auto row = static_cast<std::size_t>(kPixels / 2 + static_cast<int>(z * kPerMetre));
    const std::uint8_t* pixel = &m_pixels[(row * kPixels + column) * 4];
    return {pixel[0], pixel[1], pixel[2]};
}

void TestLights::aSpotLightsWhatItIsTurnedTo()
{
    shine(night(), {spotOn({1.0F, 0.0F, -2.0F})});
    const int dark = at(-2.0F, 2.0F).y;
    QVERIFY(dark < 60);
    QVERIFY2(at(1.0F, -2.0F).y > dark + 60, qPrintable(QString::number(at(1.0F, -2.0F).y)));
    QVERIFY(at(1.5F, -2.0F).y > dark + 50); // within
    QCOMPARE(at(1.9F, -2.0F).y, dark);      // and beside its edge
    // A softer one is darker towards its edge.
    model::Light soft = spotOn({1.0F, 0.0F, -2.0F});
    const int sharp = at(1.55F, -2.0F).y;
    soft.softness = 1.0F;
    shine(night(), {soft});
    QVERIFY(at(1.55F, -2.0F).y < sharp - 20);
    QVERIFY(at(1.0F, -2.0F).y > dark + 60);
    // Somebody moved it.
    shine(night(), {spotOn({-1.0F, 0.0F, 2.0F})});
    QCOMPARE(at(1.0F, -2.0F).y, dark);
    QVERIFY(at(-1.0F, 2.0F).y > dark + 60);
}

void TestLights::aPointLightShinesToAllSides()
{
    model::Light light = spotOn({0.0F, 0.0F, 0.0F});
    light.kind = model::LightKind::Point;
    light.position = {0.0F, 2.0F, 0.0F};
    light.strength = 0.02F;
    shine(night(), {light});
    const int middle = at(0.0F, 0.0F).y;
    for (const auto& [x, z] : {std::pair(2.0F, 0.0F), {-2.0F, 0.0F}, {0.0F, 2.0F}, {0.0F, -2.0F}}) {
        QVERIFY(at(x, z).y > at(3.9F, 3.9F).y && at(x, z).y < middle);
        QVERIFY(std::abs(at(x, z).y - at(2.0F, 0.0F).y) <= 4);
    }
}

void TestLights::streetLampsGoOnAfterDark()
{
    model::Light lamp = spotOn({1.0F, 0.0F, -2.0F});
    shine(night(), {lamp});
    const std::vector<std::uint8_t> lit = m_pixels;
    lamp.isOnlyAfterDark = true;
    shine(night(), {lamp});
    QCOMPARE(m_pixels, lit);
    render::RenderInput day = night();
    day.lighting = model::Lighting();
    shine(day, {});
    const std::vector<std::uint8_t> sunny = m_pixels;
    shine(day, {lamp});
    QCOMPARE(m_pixels, sunny);
    lamp.isOnlyAfterDark = false;
    shine(day, {lamp});
    QVERIFY(m_pixels != sunny);
}

void TestLights::aLargeLampDoesNotBurn()
{
    model::Light light = spotOn({0.0F, 0.0F, 0.0F});
    light.kind = model::LightKind::Point;
    light.position = {0.0F, 0.5F, 0.0F};
    light.strength = 0.02F;
    shine(night(), {light});
    QVERIFY(at(0.0F, 0.0F).y == 255);
    const int away = at(3.9F, 0.0F).y;
    light.sizeMetres = 3.0F;
    shine(night(), {light});
    QVERIFY2(at(0.0F, 0.0F).y < 230, qPrintable(QString::number(at(0.0F, 0.0F).y)));
    QVERIFY(at(0.0F, 0.0F).y > away); // it is no darker under it than beside it
    QCOMPARE(at(3.9F, 0.0F).y, away);
    // Nor does its size take anything from a cone.
    model::Light spot = spotOn({1.0F, 0.0F, -2.0F});
    shine(night(), {spot});
    const std::vector<std::uint8_t> small = m_pixels;
    spot.sizeMetres = 9.0F;
    shine(night(), {spot});
    QCOMPARE(m_pixels, small);
}

void TestLights::theColourIsTheLights()
{
    model::Light light = spotOn({0.0F, 0.0F, 0.0F});
    light.color = {255, 0, 0};
    const glm::ivec3 dark = (shine(night(), {}), at(0.0F, 0.0F));
    shine(night(), {light});
    QVERIFY(at(0.0F, 0.0F).x > dark.x + 60);
    QCOMPARE(at(0.0F, 0.0F).y, dark.y);
    QCOMPARE(at(0.0F, 0.0F).z, dark.z);
}

void TestLights::whatIsOffCostsNoPixel()
{
    shine(night(), {});
    const std::vector<std::uint8_t> without = m_pixels;
    model::Light off = spotOn({0.0F, 0.0F, 0.0F});
    off.isOn = false;
    model::Light nobody = spotOn({0.0F, 0.0F, 0.0F});
    nobody.aim = model::LightAim::Person;
    nobody.person = 77;
    shine(night(), {off, nobody});
    QCOMPARE(m_pixels, without);
    render::RenderInput plain = night();
    plain.look = render::Look::Plain;
    draw(plain);
    const std::vector<std::uint8_t> unlit = m_pixels;
    shine(plain, {spotOn({0.0F, 0.0F, 0.0F})});
    QCOMPARE(m_pixels, unlit);
}

void TestLights::stagesAndPeopleAreLit()
{
    render::RenderInput input = night();
    input.frame = frameOf(makeRow(1), {entryFor(m_man)});
    model::StageEntry entry;
    entry.asset = makeSheet({{{1, 0.1F, 3}, {3, 0.1F, 3}, {3, 0.1F, 1}, {1, 0.1F, 1}}});
    input.stages = {&entry, 1};
    shine(input, {});
    const int darkMan = at(0.0F, 0.0F).y;
    const int darkStage = at(2.0F, 2.0F).y;
    // In the middle of a large triangle, far from its corners.
    shine(input, {spotOn({0.0F, 0.0F, 0.0F}), spotOn({2.0F, 0.0F, 2.0F})});
    QVERIFY(at(0.0F, 0.0F).y > darkMan + 40);
    QVERIFY(at(2.0F, 2.0F).y > darkStage + 60);
    QCOMPARE(at(1.1F, 2.9F).y, darkStage);
}

void TestLights::aFollowSpotGoesWithHim()
{
    render::RenderInput input = night();
    model::Population people = makeRow(2);
    const auto places = people.column(model::columns::position);
    model::Light light = spotOn(places[1]);
    light.aim = model::LightAim::Person;
    light.person = people.ids()[1];
    light.target = {0.0F, 0.0F, 30.0F};
    input.frame = frameOf(people, {entryFor(m_man)});
    shine(input, {});
    const int dark = at(places[1].x, places[1].z).y;
    shine(input, {light});
    QVERIFY(at(places[1].x, places[1].z).y > dark + 40);
    const glm::vec3 middle = (places[0] + places[1]) * 0.5F;
    setAll(people, model::columns::group, model::GroupId{3});
    input.frame = frameOf(people, {entryFor(m_man)});
    light.aim = model::LightAim::Group;
    light.group = 3;
    shine(input, {light});
    QVERIFY(at(middle.x, middle.z).y > at(middle.x, middle.z + 2.5F).y);
}

void TestLights::theStrongestShine()
{
    std::vector<model::Light> many;
    for (int i = 0; i < 100; ++i) {
        many.push_back(spotOn({-3.0F, 0.0F, -3.0F}));
        many.back().id = static_cast<model::LightId>(i + 1);
        many.back().strength = 0.001F;
    }
    many[60] = spotOn({2.0F, 0.0F, 2.0F});
    shine(night(), many);
    QVERIFY(at(2.0F, 2.0F).y > at(0.0F, 0.0F).y + 60);
}

void TestLights::whatRulesSayIsSeen()
{
    render::RenderInput input = night();
    model::Light light = spotOn({1.0F, 0.0F, -2.0F});
    light.position += glm::vec3(0.0F, 0.0F, 6.0F);
    light.isOn = false;
    const auto shown = [&](model::LightDeed deed, double now) {
        auto cues = std::make_shared<model::LightCues>();
        tellLight(*cues, light, model::LightDeed::On, 0.0F, 0.0);
        tellLight(*cues, light, deed, 2.0F, 1.0);
        auto frame = std::make_shared<model::CrowdFrame>(*input.frame);
        frame->lightCues = cues;
        frame->seconds = now;
        input.frame = frame;
        shine(input, {light});
        return at(1.0F, -2.0F).y;
    };
    shine(input, {light});
    const int dark = at(1.0F, -2.0F).y;
    const int lit = shown(model::LightDeed::On, 1.5);
    QVERIFY(lit > dark + 40);
    const int half = shown(model::LightDeed::Off, 2.0);
    QVERIFY(half > dark && half < lit);
    QCOMPARE(shown(model::LightDeed::Off, 3.5), dark);
    QVERIFY(shown(model::LightDeed::Flash, 1.0) > lit + 20);
    QCOMPARE(shown(model::LightDeed::Sweep, 1.5), dark); // away to one side
    QCOMPARE(shown(model::LightDeed::Sweep, 9.0), lit);  // and back
}

void TestLights::stagesStandInTheLight()
{
    render::RenderInput input = night();
    const model::StageEntry board = boardOver(-1.0F, 1.0F, 2.0F);
    input.stages = {&board, 1};
    model::Light light = slanting(0.0F, 1.0F);
    light.castsShadows = false;
    shine(input, {});
    const int dark = at(1.0F, 1.0F).y;
    shine(input, {light});
    const int lit = at(1.0F, 1.0F).y;
    QVERIFY(lit > dark + 50);
    light.castsShadows = true;
    for (int picture = 0; picture < 3; ++picture) { // also when what stands still is kept
        shine(input, {light});
        QVERIFY2(at(1.0F, 1.0F).y <= dark + 2, qPrintable(QString::number(at(1.0F, 1.0F).y)));
        QVERIFY(std::abs(at(1.0F, -0.2F).y - at(1.0F, 2.2F).y) < 12); // beside it
        QVERIFY(at(1.0F, -0.2F).y > dark + 40);
        QVERIFY(at(-1.0F, 1.0F).y > dark + 40); // the board itself is lit
    }
    // The lamp is moved, and the shadow moves.
    light.position.x = 10.0F;
    shine(input, {light});
    QVERIFY(at(1.0F, 1.0F).y > dark + 40);
    QVERIFY2(at(-3.2F, 1.0F).y <= dark + 2, qPrintable(QString::number(at(-3.2F, 1.0F).y)));
    input.showShadows = false;
    shine(input, {light});
    QVERIFY(at(-3.2F, 1.0F).y > dark + 10);
}

void TestLights::peopleStandInTheLight()
{
    render::RenderInput input = night();
    model::Light light = slanting(0.5F, 0.0F);
    shine(input, {light});
    const int lit = at(0.9F, 0.0F).y;
    input.frame = frameOf(makeRow(1), {entryFor(m_man)});
    for (const float pixels : {0.0F, 1e6F}) { // the finest level, and the coarsest
        input.levels = {{pixels, pixels, pixels}, 0.0F};
        shine(input, {light});
        QVERIFY2(at(0.9F, 0.0F).y < lit - 40, qPrintable(QString::number(at(0.9F, 0.0F).y)));
        QVERIFY(std::abs(at(0.9F, 1.5F).y - at(0.9F, -1.5F).y) < 12);
        QVERIFY(at(0.9F, 1.5F).y > lit - 40);
    }
    // Who stands in the shadow of a board is dark, too.
    const model::StageEntry board = boardOver(-2.1F, 0.0F, 3.9F);
    light.castsShadows = false;
    shine(input, {light});
    const int face = at(0.0F, 0.0F).y;
    input.stages = {&board, 1};
    light.castsShadows = true;
    shine(input, {light});
    QVERIFY2(at(0.0F, 0.0F).y < face - 30, qPrintable(QString::number(at(0.0F, 0.0F).y)));
}

void TestLights::whatShinesToAllSidesCasts()
{
    render::RenderInput input = night();
    model::Light lamp = spotOn({0.0F, 0.0F, 0.0F});
    lamp.kind = model::LightKind::Point;
    lamp.position = {0.0F, 1.0F, 0.0F}; // the ground is seen by its lower side and by four others
    lamp.strength = 0.02F;
    shine(input, {lamp});
    const std::vector<std::uint8_t> open = m_pixels;
    lamp.castsShadows = true;
    shine(input, {lamp});
    int most = 0; // where nothing stands, nothing is dark: neither by itself nor between the sides
    for (std::size_t i = 0; i < open.size(); ++i) {
        most = std::max(most, std::abs(open[i] - m_pixels[i]));
    }
    QVERIFY2(most <= 1, qPrintable(QString::number(most)));
    for (const float side : {1.0F, -1.0F}) {
        const model::StageEntry board = boardOver(side, 0.0F, 0.5F);
        input.stages = {&board, 1};
        shine(input, {lamp});
        QVERIFY2(at(2.4F * side, 0.0F).y < at(-2.4F * side, 0.0F).y - 20,
                 qPrintable(QString::number(at(2.4F * side, 0.0F).y)));
        QVERIFY(std::abs(at(0.0F, 2.4F).y - at(0.0F, -2.4F).y) <= 4);
        QVERIFY(std::abs(at(0.0F, 2.4F).y - at(-2.4F * side, 0.0F).y) <= 4);
    }
    input.stages = {};
    input.frame = frameOf(makeRow(1), {entryFor(m_man)});
    lamp.position = {-1.5F, 1.0F, 0.0F};
    shine(input, {lamp});
    QVERIFY2(at(2.0F, 0.0F).y < at(1.5F, 2.5F).y - 4,
             qPrintable(QString::number(at(2.0F, 0.0F).y)));
}

void TestLights::beamsAreCut()
{
    render::RenderInput input = night();
    input.frame = frameOf(makeRow(1), {entryFor(m_man)});
    input.lighting.ground = glm::vec3(0.0F); // the air alone is seen
    model::Light light = spotOn({3.5F, 1.2F, 0.0F});
    light.position = {-3.0F, 1.2F, 0.0F};
    light.coneRadians = 0.2F;
    light.strength = 4.0F;
    light.beam = 1.0F;
    shine(input, {light});
    const int before = at(-1.5F, 0.0F).y;
    const int behind = at(2.0F, 0.0F).y;
    QVERIFY2(behind > 12, qPrintable(QString::number(behind)));
    light.castsShadows = true;
    shine(input, {light});
    QVERIFY2(std::abs(at(-1.5F, 0.0F).y - before) <= 2,
             qPrintable(QString::number(at(-1.5F, 0.0F).y)));
    QVERIFY2(at(2.0F, 0.0F).y < behind * 3 / 4, qPrintable(QString::number(at(2.0F, 0.0F).y)));
    // The same without anybody: the beam is whole.
    input.frame = frameOf(model::Population(), {entryFor(m_man)});
    shine(input, {light});
    QVERIFY2(std::abs(at(2.0F, 0.0F).y - behind) <= 2,
             qPrintable(QString::number(at(2.0F, 0.0F).y)));
}

/// What is within a beam has as much of its air before it as one looks through.
void TestLights::beamsThickenOnTheWay()
{
    render::RenderInput input = night();
    input.lighting.ground = glm::vec3(0.0F);
    model::Light light = spotOn({3.5F, 1.2F, 0.0F});
    light.position = {-3.0F, 1.2F, 0.0F};
    light.coneRadians = 0.2F; // 0.45 m to each side where it is looked at
    light.strength = 4.0F;
    const auto linear = [this] { return std::pow(at(1.5F, 0.0F).y / 255.0, 2.2); };
    const auto airOver = [&](float height) {
        const model::StageEntry board = boardOver(1.5F, 0.0F, height);
        input.stages = {&board, 1};
        light.beam = 0.0F;
        shine(input, {light});
        const double without = linear();
        light.beam = 1.0F;
        shine(input, {light});
        return linear() - without;
    };
    const double all = airOver(0.3F);
    const double half = airOver(1.2F) / all;
    const double little = airOver(1.55F) / all;
    QVERIFY(all > 0.002);
    QVERIFY2(half > 0.35 && half < 0.65, qPrintable(QString::number(half)));
    QVERIFY2(little < 0.25, qPrintable(QString::number(little)));
    QVERIFY(airOver(1.9F) < 0.02 * all + 1e-4);
}

void TestLights::theStrongestCast()
{
    render::RenderInput input = night();
    const model::StageEntry board = boardOver(-1.0F, 1.0F, 2.0F);
    input.stages = {&board, 1};
    std::vector<model::Light> lights;
    for (int i = 0; i < 8; ++i) { // beside it, and stronger
        lights.push_back(spotOn({-3.0F, 0.0F, -3.0F}));
        lights.back().castsShadows = i != 0;
        lights.back().strength = 0.61F;
    }
    lights.push_back(slanting(0.0F, 1.0F));
    shine(input, lights);
    const int lit = at(1.0F, 1.0F).y;
    lights[2].castsShadows = lights[3].castsShadows = lights[4].castsShadows = false;
    lights[5].castsShadows = false;
    shine(input, lights); // three of them are left
    QVERIFY(at(1.0F, 1.0F).y < lit - 40);
}

void TestLights::oddOnesDoNoHarm()
{
    model::Light inside = spotOn({0.0F, 0.0F, 0.0F}); // the lamp where it is turned to
    inside.position = inside.target;
    model::Light wide = spotOn({0.0F, 0.0F, 0.0F});
    wide.coneRadians = 3.0F;
    model::Light black = spotOn({0.0F, 0.0F, 0.0F});
    black.color = {0, 0, 0};
    model::Light strong = spotOn({3.0F, 0.0F, 3.0F});
    strong.strength = 1000.0F;
    model::Light far = spotOn({1e6F, 0.0F, -1e6F});
    shine(night(), {inside, wide, black, strong, far});
    QVERIFY(at(3.0F, 3.0F).y == 255);
    QVERIFY(at(-2.0F, 2.0F).y > 0 && at(-2.0F, 2.0F).y < 255);
}

void TestLights::aLampInAWallShinesOnlyOutOfIt()
{
    render::RenderInput input = night();
    const std::vector<model::StageEntry> stages{boardOver(0.0F, 0.0F, 1.0F)};
    input.stages = stages;
    model::Light within = slanting(0.0F, 0.0F);
    within.kind = model::LightKind::Point;
    within.position = {0.0F, 1.0F, 0.0F}; // in the board itself
    within.strength = 0.05F;
    shine(input, {within});
    const std::vector<std::uint8_t> once = m_pixels;
    QVERIFY(at(0.0F, 0.0F).y >= 0);
    QVERIFY(at(3.0F, 0.0F).y > 0 && at(3.0F, 0.0F).y < 255);
    shine(input, {within});
    QCOMPARE(m_pixels, once);
}

void TestLights::aBlackSunIsNoSun()
{
    render::RenderInput none = night();
    none.lighting.shadowStrength = 1.0F;
    draw(none);
    const std::vector<std::uint8_t> dark = m_pixels;
    render::RenderInput black = none;
    black.lighting.sunStrength = 1000.0F;
    black.lighting.sunColor = glm::vec3(0.0F);
    black.lighting.highlights = 4.0F;
    draw(black);
    QCOMPARE(m_pixels, dark);
}

void TestLights::oddCastersDoNoHarm()
{
    render::RenderInput input = night();
    input.frame = frameOf(makeRow(1), {entryFor(m_man)});
    shine(input, {slanting(0.5F, 0.0F)});
    const int shadowed = at(0.9F, 0.0F).y;
    model::Light inside = slanting(3.0F, 3.0F); // the lamp where it is turned to
    inside.position = inside.target;
    model::Light wide = slanting(0.0F, 0.0F);
    wide.coneRadians = 3.0F;
    wide.strength = 0.01F;
    model::Light narrow = slanting(-3.0F, 3.0F);
    narrow.coneRadians = 0.01F;
    model::Light far = slanting(1e6F, -1e6F);
    shine(input, {inside, wide, narrow, far, slanting(0.5F, 0.0F)});
    QVERIFY2(std::abs(at(0.9F, 0.0F).y - shadowed) < 30,
             qPrintable(QString::number(at(0.9F, 0.0F).y)));
}

/// A board over a board: lamps light what is seen, and boards that lie on each other as without.
void TestLights::whatIsHiddenIsNotLit()
{
    const std::vector<model::StageEntry> boards{
        boardOver(1.0F, 1.0F, 0.5F), boardOver(1.0F, 1.0F, 1.5F), boardOver(-2.0F, -2.0F, 0.5F),
        boardOver(-2.0F, -2.0F, 0.5F)};
    render::RenderInput input = night();
    input.stages = boards;
    model::Light spot = spotOn({1.0F, 0.0F, 1.0F});
    spot.coneRadians = 0.5F;
    shine(input, {spot});
    const int lit = at(1.0F, 1.0F).y;
    const int coplanar = at(-2.0F, -2.0F).y;
    input.stages = {boards.data() + 1, 2}; // without those beneath
    shine(input, {spot});
    QCOMPARE(at(1.0F, 1.0F).y, lit);
    QCOMPARE(at(-2.0F, -2.0F).y, coplanar);
    QVERIFY(lit > coplanar + 40);
}

void TestLights::aCameraInsideSomebodySeesOut_data()
{
    QTest::addColumn<render::Look>("look");
    for (const render::LookInfo& info : render::kLooks) {
        QTest::newRow(info.key) << info.look;
    }
}

/// With all that light can do, and a lamp in the same place.
void TestLights::aCameraInsideSomebodySeesOut()
{
    QFETCH(const render::Look, look);
    const model::Camera camera = model::Camera::lookingAt({0.0F, 1.1F, 0.0F}, {4.0F, 0.0F, 0.5F});
    render::RenderInput input(model::View(camera, glm::vec2(kPixels)), *m_keyframes);
    input.frame = frameOf(makeRow(3), {entryFor(m_man)});
    const model::StageEntry board = boardOver(4.0F, 0.0F, 0.5F);
    input.stages = {&board, 1};
    input.look = look;
    input.lighting.shadowStrength = 1.0F;
    input.lighting.occlusion = 1.0F;
    input.lighting.highlights = 1.0F;
    model::Light lamp = slanting(0.0F, 0.0F);
    lamp.position = camera.position;
    shine(input, {lamp});
    std::set<std::uint32_t> colours;
    for (std::size_t i = 0; i < m_pixels.size(); i += 4) {
        QCOMPARE(m_pixels[i + 3], std::uint8_t{255});
        const std::uint32_t red = m_pixels[i];
        const std::uint32_t green = m_pixels[i + 1];
        colours.insert(red << 16U | green << 8U | m_pixels[i + 2]);
    }
    QVERIFY2(colours.size() > 2, QByteArray::number(static_cast<int>(colours.size())));
}

CROWD_TEST(TestLights)
#include "tst_Lights.moc"
