// SPDX-License-Identifier: MIT
#include <array>
#include <cstdlib>
#include <span>
#include <vector>

#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

constexpr int kPlaces = 24; ///< of the lens
constexpr float kNear = 6.0F;
constexpr float kFar = 20.0F;

} // namespace

/// Depth of field: two men, six and twenty metres away, the near one left.
class TestLens : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { open(); }
    void cleanupTestCase() { m_renderer->destroy(); }
    void whatIsInFocusIsSharp();
    void aPinholeSeesAllSharp();
    void parallelViewsHaveNone();

private:
    [[nodiscard]] render::RenderInput twoMen(const model::Camera& camera);
    void ripen(render::RenderInput input, float focus, float radius);
    /// How far the last picture is from another, in the left or right half.
    [[nodiscard]] int difference(const std::vector<std::uint8_t>& sharp, bool isRight) const;
};

render::RenderInput TestLens::twoMen(const model::Camera& camera)
{
    model::Population men = makeRow(2);
    const std::array<model::IndividualId, 1> left{1};
    const std::array<model::IndividualId, 1> right{2};
    const glm::vec3 nearPlace(-1.0F, 0.0F, -kNear);
    const glm::vec3 farPlace(3.0F, 0.0F, -kFar);
    men.setValues(model::columns::position, left, std::span(&nearPlace, 1));
    men.setValues(model::columns::position, right, std::span(&farPlace, 1));
    render::RenderInput input(model::View(camera, glm::vec2(kPixels)), *m_keyframes);
    input.frame = frameOf(men, {entryFor(m_man)});
    input.samples = 0;
    input.showGround = false;
    input.lighting.shadowStrength = 0.0F;
    input.background = {0.0F, 0.0F, 0.0F, 1.0F};
    return input;
}

void TestLens::ripen(render::RenderInput input, float focus, float radius)
{
    draw(input); // his clip is ready
    input.lens = render::Lens{focus, radius};
    for (int n = 0; n < kPlaces; ++n) {
        input.ripeness = n;
        const auto drawn = m_renderer->draw(input);
        QVERIFY2(drawn.isOk(), drawn ? "" : drawn.error().message.c_str());
    }
    m_pixels = m_renderer->readPixels();
}

int TestLens::difference(const std::vector<std::uint8_t>& sharp, bool isRight) const
{
    int sum = 0;
    for (std::size_t i = 0; i < m_pixels.size(); i += 4) {
        const bool isHere = (i / 4 % kPixels >= kPixels / 2) == isRight;
        sum += isHere ? std::abs(static_cast<int>(m_pixels[i]) - static_cast<int>(sharp[i])) : 0;
    }
    return sum;
}

void TestLens::whatIsInFocusIsSharp()
{
    const auto camera = model::Camera::lookingAt({0.0F, 1.0F, 0.0F}, {0.0F, 1.0F, -10.0F});
    const render::RenderInput input = twoMen(camera);
    ripen(input, kNear, 0.0F);
    const std::vector<std::uint8_t> sharp = m_pixels;
    ripen(input, kNear, 0.25F);
    const int nearInFocus = difference(sharp, false);
    const int farSoft = difference(sharp, true);
    ripen(input, kFar, 0.25F);
    const int nearSoft = difference(sharp, false);
    const int farInFocus = difference(sharp, true);
    const auto said = QStringLiteral("near %1 sharp, %2 soft; far %3 sharp, %4 soft")
                          .arg(nearInFocus)
                          .arg(nearSoft)
                          .arg(farInFocus)
                          .arg(farSoft);
    QVERIFY2(nearSoft > 6 * nearInFocus && nearSoft > 1000, qPrintable(said));
    QVERIFY2(farSoft > 4 * farInFocus && farSoft > 500, qPrintable(said));
}

/// As what ripens without a lens does.
void TestLens::aPinholeSeesAllSharp()
{
    const auto camera = model::Camera::lookingAt({0.0F, 1.0F, 0.0F}, {0.0F, 1.0F, -10.0F});
    const render::RenderInput input = twoMen(camera);
    draw(input);
    const std::vector<std::uint8_t> sharp = m_pixels;
    render::RenderInput first = input;
    first.lens = render::Lens{kNear, 0.0F};
    first.ripeness = 0;
    draw(first);
    QVERIFY(difference(sharp, false) + difference(sharp, true) < 50);
}

void TestLens::parallelViewsHaveNone()
{
    auto camera = model::Camera::lookingAt({0.0F, 1.0F, 0.0F}, {0.0F, 1.0F, -10.0F});
    camera.projection = model::Projection::Orthographic;
    camera.orthographicHeight = 10.0F;
    const render::RenderInput input = twoMen(camera);
    ripen(input, kNear, 0.0F);
    const std::vector<std::uint8_t> sharp = m_pixels;
    ripen(input, kNear, 0.5F);
    QCOMPARE(m_pixels, sharp);
}

CROWD_TEST(TestLens)
#include "tst_Lens.moc"
