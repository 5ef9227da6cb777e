// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <QtTest/QTest>

#include "render/SceneLook.h"
#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"

using namespace crowd;
using namespace crowd::testing;
using model::LookPreset;

/// What a look of the scene changes in a picture of one man from above.
class TestSceneLook : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { open(); }
    void cleanupTestCase() { m_renderer->destroy(); }
    void theSceneIsAsItWas();
    void aBackgroundIsOneColour();
    void outlinesAreDrawnInTheirColour();
    void aStyleCanBeWithoutItsOutlines();
    void lightIsThatOfTheLook();
    void lightCanBeItsOwn();
    void whatIsOffIsNotDrawn();

private:
    [[nodiscard]] render::RenderInput oneMan();
    [[nodiscard]] render::RenderInput oneMan(const LookPreset& look);
    [[nodiscard]] std::array<int, 3> pixel(int x, int y) const;
    [[nodiscard]] int countOf(const std::array<int, 3>& color) const;
    [[nodiscard]] int countOfRed() const; ///< also where ink is thin

    std::vector<model::Light> m_lamps = std::vector<model::Light>(1);
};

render::RenderInput TestSceneLook::oneMan()
{
    render::RenderInput input(above(), *m_keyframes);
    input.frame = frameOf(makeRow(1), {entryFor(m_man)});
    input.samples = 0;
    input.lights = m_lamps;
    input.background = {0.0F, 0.0F, 0.0F, 1.0F};
    return input;
}

render::RenderInput TestSceneLook::oneMan(const LookPreset& look)
{
    render::RenderInput input = oneMan();
    render::useLook(input, look);
    return input;
}

std::array<int, 3> TestSceneLook::pixel(int x, int y) const
{
    const std::size_t at = static_cast<std::size_t>(y * kPixels + x) * 4;
    return {m_pixels[at], m_pixels[at + 1], m_pixels[at + 2]};
}

int TestSceneLook::countOf(const std::array<int, 3>& color) const
{
    int count = 0;
    for (int y = 0; y < kPixels; ++y) {
        for (int x = 0; x < kPixels; ++x) {
            count += pixel(x, y) == color ? 1 : 0;
        }
    }
    return count;
}

int TestSceneLook::countOfRed() const
{
    int count = 0;
    for (std::size_t at = 0; at < m_pixels.size(); at += 4) {
        count += m_pixels[at] > 2 * std::max(m_pixels[at + 1], m_pixels[at + 2]) ? 1 : 0;
    }
    return count;
}

void TestSceneLook::theSceneIsAsItWas()
{
    draw(oneMan());
    const std::vector<std::uint8_t> before = m_pixels;
    draw(oneMan(LookPreset()));
    QVERIFY(m_pixels == before);
}

void TestSceneLook::aBackgroundIsOneColour()
{
    LookPreset look;
    look.style = model::LookStyle::Plain;
    look.hasGround = false;
    look.hasBackground = true;
    look.background = {200, 100, 50};
    draw(oneMan(look));
    QCOMPARE(pixel(2, 2), (std::array{200, 100, 50}));
    QVERIFY(countOf({200, 100, 50}) < kPixels * kPixels); // the man is there
}

void TestSceneLook::outlinesAreDrawnInTheirColour()
{
    LookPreset look;
    look.style = model::LookStyle::Plain;
    look.hasGround = false;
    look.hasBackground = true;
    look.hasOutline = true;
    look.outline = {255, 0, 0};
    look.outlinePixels = 2.0F;
    draw(oneMan(look));
    const int thin = countOfRed();
    QVERIFY(thin > 10);
    look.outlinePixels = 8.0F;
    draw(oneMan(look));
    QVERIFY(countOfRed() > thin);
}

void TestSceneLook::aStyleCanBeWithoutItsOutlines()
{
    LookPreset look;
    look.style = model::LookStyle::Cartoon;
    look.hasGround = false;
    look.hasBackground = true;
    draw(oneMan(look));
    const std::vector<std::uint8_t> inked = m_pixels;
    look.hasOutline = true;
    look.outlinePixels = 0.0F;
    draw(oneMan(look));
    QVERIFY(m_pixels != inked);
    look.outline = {255, 0, 0};
    const std::vector<std::uint8_t> bare = m_pixels;
    draw(oneMan(look));
    QVERIFY(m_pixels == bare);
}

void TestSceneLook::lightIsThatOfTheLook()
{
    LookPreset look;
    look.light = model::LookLight::Night;
    const auto sum = [this] {
        long total = 0;
        for (const std::uint8_t value : m_pixels) {
            total += value;
        }
        return total;
    };
    draw(oneMan());
    const long day = sum();
    draw(oneMan(look));
    QVERIFY(sum() < day * 3 / 4);
    for (std::size_t i = 0; i < model::kLookLights.size(); ++i) {
        look.light = static_cast<model::LookLight>(i);
        draw(oneMan(look)); // each is one that there is
    }
}

void TestSceneLook::lightCanBeItsOwn()
{
    draw(oneMan());
    const std::vector<std::uint8_t> scenes = m_pixels;
    LookPreset look;
    look.light = model::LookLight::Own;
    look.ownLight = oneMan().lighting;
    draw(oneMan(look));
    QVERIFY(m_pixels == scenes);
    look.ownLight.sunColor = {1.0F, 0.2F, 0.2F};
    draw(oneMan(look));
    QVERIFY(m_pixels != scenes);
    look.light = model::LookLight::Scene;
    draw(oneMan(look));
    QVERIFY(m_pixels == scenes);
}

void TestSceneLook::whatIsOffIsNotDrawn()
{
    LookPreset look;
    const render::RenderInput all = oneMan(look);
    QVERIFY(all.showGround && all.showShadows && all.lights.size() == 1 && !all.ink);
    look.hasGround = false;
    look.hasShadows = false;
    look.hasLamps = false;
    const render::RenderInput none = oneMan(look);
    QVERIFY(!none.showGround && !none.showShadows && none.lights.empty());
    render::RenderInput without = oneMan();
    without.showShadows = false; // as the view has it
    render::useLook(without, LookPreset());
    QVERIFY(!without.showShadows);
}

CROWD_TEST(TestSceneLook)
#include "tst_SceneLook.moc"
