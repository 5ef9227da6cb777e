// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <utility>

#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;
using render::AovPicture;

/// What pictures show besides colours.
class TestAovs : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { open(); }
    void cleanupTestCase() { m_renderer->destroy(); }
    void everyPixelKnowsWhatItShows();
    void whatIsHiddenIsNotThere();
    void whatIsBlendedCountsWhereItHidesMore();
    void nothingIsBehindATransparentPicture();
    void whatMovedSaysFromWhere();
    void posesMoveToo();
    void theSkyTurnsWithTheCamera();
    void theColoursStay();
    void itIsOfAnySize();

private:
    [[nodiscard]] render::RenderInput twoMen();
    [[nodiscard]] AovPicture aovs(const render::RenderInput& input);
};

/// At 0 and 1 m along X, from above.
render::RenderInput TestAovs::twoMen()
{
    render::RenderInput input(above(), *m_keyframes);
    input.frame = frameOf(makeRow(2), {entryFor(m_man)});
    input.samples = 0;
    return input;
}

AovPicture TestAovs::aovs(const render::RenderInput& input)
{
    draw(input); // keyframes
    auto drawn = m_renderer->drawAovs(input);
    return drawn ? std::move(drawn).value() : AovPicture();
}

namespace {

/// Where something stands in a picture from above.
std::size_t pixelAt(float x, float z)
{
    const float half = static_cast<float>(kPixels) / 2.0F;
    const auto column = static_cast<std::size_t>(half + x * kPerMetre);
    const auto line = static_cast<std::size_t>(half + z * kPerMetre);
    return line * static_cast<std::size_t>(kPixels) + column;
}

} // namespace

void TestAovs::everyPixelKnowsWhatItShows()
{
    const AovPicture picture = aovs(twoMen());
    QCOMPARE(picture.size, glm::ivec2(kPixels));
    QCOMPARE(picture.rows.size(), static_cast<std::size_t>(kPixels * kPixels));
    const std::array<std::pair<glm::vec2, int>, 3> places{
        {{{0.1F, 0.1F}, 0}, {{1.1F, 0.1F}, 1}, {{-2.0F, -3.0F}, AovPicture::kThing}}};
    for (const auto& [place, row] : places) {
        const std::size_t pixel = pixelAt(place.x, place.y);
        QCOMPARE(picture.rows[pixel], row);
        const glm::vec3 seen = picture.places[pixel];
        const float height = row >= 0 ? 1.8F : 0.0F; // hats, and the ground
        QVERIFY2(std::abs(seen.x - place.x) < 0.07F && std::abs(seen.z - place.y) < 0.07F &&
                     std::abs(seen.y - height) < 0.01F,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(seen.x).arg(seen.y).arg(seen.z)));
        QVERIFY(glm::dot(picture.normals[pixel], glm::vec3(0, 1, 0)) > 0.98F);
    }
}

/// A roof over the first of them; from below it is seen from its other side.
void TestAovs::whatIsHiddenIsNotThere()
{
    model::StageEntry roof;
    auto sheet = makeSheet({{{-0.6F, 3, 1}, {0.6F, 3, 1}, {0.6F, 3, -1}, {-0.6F, 3, -1}}});
    sheet->materials[0].doubleSided = true;
    roof.asset = sheet;
    const std::array stages{std::move(roof)};
    render::RenderInput input = twoMen();
    input.stages = stages;
    AovPicture picture = aovs(input);
    QCOMPARE(picture.rows[pixelAt(0.1F, 0.1F)], AovPicture::kThing);
    QVERIFY(std::abs(picture.places[pixelAt(0.1F, 0.1F)].y - 3.0F) < 1e-3F);
    QCOMPARE(picture.rows[pixelAt(1.1F, 0.1F)], 1);

    model::Camera below = model::Camera::lookingAt({0, 2.5F, 0}, {0, 10, 0});
    below.projection = model::Projection::Orthographic;
    below.orthographicHeight = 1.0F;
    input.frame = nullptr; // such a camera sees what is behind it, too
    input.showGround = false;
    input.view = model::View(below, glm::vec2(kPixels));
    picture = aovs(input);
    QCOMPARE(picture.rows[pixelAt(0, 0)], AovPicture::kThing);
    QVERIFY(picture.normals[pixelAt(0, 0)].y < -0.98F);
}

void TestAovs::whatIsBlendedCountsWhereItHidesMore()
{
    const auto rowWith = [this](float alpha) {
        auto man = makeBoxMan();
        for (auto& slot : man->slots) {
            for (model::MaterialChoice& choice : slot.choices) {
                choice.alphaMode = model::AlphaMode::Blend;
                choice.baseColor.a = alpha;
            }
        }
        render::RenderInput input = twoMen();
        input.frame = frameOf(makeRow(1), {entryFor(man)});
        return aovs(input).rows[pixelAt(0.1F, 0.1F)];
    };
    QCOMPARE(rowWith(0.98F), 0);
    QCOMPARE(rowWith(0.6F), 0);
    QCOMPARE(rowWith(0.3F), AovPicture::kThing);
}

void TestAovs::nothingIsBehindATransparentPicture()
{
    render::RenderInput input = twoMen();
    input.isTransparent = true;
    const AovPicture picture = aovs(input);
    QCOMPARE(picture.rows[pixelAt(-2, -3)], AovPicture::kNothing);
    QCOMPARE(picture.places[pixelAt(-2, -3)], glm::vec3(0.0F));
    QCOMPARE(picture.normals[pixelAt(-2, -3)], glm::vec3(0.0F));
    QCOMPARE(picture.rows[pixelAt(0.1F, 0.1F)], 0);
}

namespace {

bool isAbout(const glm::vec2& seen, const glm::vec2& expected, float pixels = 0.02F)
{
    const bool isSo = glm::distance(seen, expected) <= pixels;
    if (!isSo) {
        qWarning("%f %f instead of %f %f", static_cast<double>(seen.x), static_cast<double>(seen.y),
                 static_cast<double>(expected.x), static_cast<double>(expected.y));
    }
    return isSo;
}

} // namespace

void TestAovs::whatMovedSaysFromWhere()
{
    render::RenderInput input = twoMen();
    QVERIFY(aovs(input).before.empty());
    model::Population people = input.frame->population;
    const std::vector<model::IndividualId> first{people.ids()[0]};
    people.setValues<glm::vec3>(model::columns::position, first,
                                std::vector<glm::vec3>{{-0.25F, 0.0F, 0.5F}});
    const model::CrowdFramePtr before = frameOf(people, {entryFor(m_man)});
    input.earlier = render::EarlierMoment{before, above().camera()};
    AovPicture picture = aovs(input);
    QVERIFY(isAbout(picture.before[pixelAt(0.1F, 0.1F)], {-0.25F * kPerMetre, -0.5F * kPerMetre}));
    QVERIFY(isAbout(picture.before[pixelAt(1.1F, 0.1F)], {0, 0}));
    QVERIFY(isAbout(picture.before[pixelAt(-2, -3)], {0, 0}));

    input.earlier->camera.position.x += 1.0F; // and everything was further to the left
    picture = aovs(input);
    QVERIFY(isAbout(picture.before[pixelAt(1.1F, 0.1F)], {-kPerMetre, 0}));
    QVERIFY(isAbout(picture.before[pixelAt(-2, -3)], {-kPerMetre, 0}));

    // Nobody, other people, other templates, somebody out of the picture: none of them is met.
    input.earlier->camera = above().camera();
    input.earlier->frame = nullptr;
    QVERIFY(isAbout(aovs(input).before[pixelAt(0.1F, 0.1F)], {0, 0}));
    input.earlier->frame = frameOf(people, {entryFor(makeBoxMan())});
    QVERIFY(isAbout(aovs(input).before[pixelAt(0.1F, 0.1F)], {0, 0}));
    model::Population fewer = people;
    fewer.remove(first);
    input.earlier->frame = frameOf(fewer, {entryFor(m_man)});
    QVERIFY(isAbout(aovs(input).before[pixelAt(0.1F, 0.1F)], {0, 0}));
    people.setValues<glm::vec3>(model::columns::position, first,
                                std::vector<glm::vec3>{{-50.0F, 0.0F, 0.0F}});
    input.earlier->frame = frameOf(people, {entryFor(m_man)});
    QVERIFY(isAbout(aovs(input).before[pixelAt(0.1F, 0.1F)], {-50.0F * kPerMetre, 0}, 0.1F));
}

/// Somebody who rises, from the front; his clip of before is nobody's any more.
void TestAovs::posesMoveToo()
{
    model::Camera front = model::Camera::lookingAt({0, 1, 10}, {0, 1, 0});
    front.projection = model::Projection::Orthographic;
    front.orthographicHeight = static_cast<float>(kPixels) / kPerMetre;
    model::Population people = twoMen().frame->population;
    const std::vector<model::IndividualId> first{people.ids()[0]};
    const auto inClip = [&](std::uint16_t clip, double seconds) {
        people.setValues<std::uint16_t>(model::columns::clip, first,
                                        std::vector<std::uint16_t>{clip});
        auto frame = std::make_shared<model::CrowdFrame>(*frameOf(people, {entryFor(m_man)}));
        frame->seconds = seconds;
        return model::CrowdFramePtr(frame);
    };
    render::RenderInput input(model::View(front, glm::vec2(kPixels)), *m_keyframes);
    input.samples = 0;
    input.frame = inClip(1, 0.75);
    input.earlier = render::EarlierMoment{inClip(1, 0.3), front};
    const std::size_t chest = pixelAt(0.1F, -0.5F); // of the picture: half a metre above its middle
    QVERIFY(isAbout(aovs(input).before[chest], {0, -0.3F * kPerMetre}, 0.1F));
    input.frame = inClip(0, 0.75);
    QVERIFY(isAbout(aovs(input).before[chest], {0, 0.2F * kPerMetre}, 0.1F));
}

void TestAovs::theSkyTurnsWithTheCamera()
{
    const model::Camera now = model::Camera::lookingAt({0, 2, 0}, {0, 12, -10});
    model::Camera before = model::Camera::lookingAt({3, 2, 0}, {2, 12, -10});
    render::RenderInput input(model::View(now, glm::vec2(kPixels)), *m_keyframes);
    input.earlier = render::EarlierMoment{nullptr, before};
    const AovPicture picture = aovs(input);
    const std::size_t middle = pixelAt(0, 0);
    QCOMPARE(picture.rows[middle], AovPicture::kNothing);
    QVERIFY(picture.before[middle].x > 4.0F && std::abs(picture.before[middle].y) < 2.0F);
    before = now;
    before.position.x += 30.0F; // far away it does not matter
    input.earlier->camera = before;
    QVERIFY(isAbout(aovs(input).before[middle], {0, 0}));
}

void TestAovs::theColoursStay()
{
    const render::RenderInput input = twoMen();
    draw(input);
    const auto before = m_pixels;
    QVERIFY(m_renderer->drawAovs(input).isOk());
    QVERIFY(m_renderer->readPixels() == before);
    draw(input);
    QVERIFY(m_pixels == before);
}

void TestAovs::itIsOfAnySize()
{
    render::RenderInput input = twoMen();
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 200)}) {
        input.pixelSize = size;
        const AovPicture picture = aovs(input);
        QCOMPARE(picture.size, size);
        QCOMPARE(picture.normals.size(), static_cast<std::size_t>(size.x * size.y));
    }
    input.frame = nullptr;
    QCOMPARE(aovs(input).rows[0], AovPicture::kThing);
}

CROWD_TEST(TestAovs)
#include "tst_Aovs.moc"
