// SPDX-License-Identifier: MIT
#include <QtTest/QtTest>

#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

struct Rgb
{
    int red = 0;
    int green = 0;
    int blue = 0;
};

bool isNear(const Rgb& a, const Rgb& b, int distance = 3)
{
    return std::abs(a.red - b.red) <= distance && std::abs(a.green - b.green) <= distance &&
           std::abs(a.blue - b.blue) <= distance;
}

} // namespace

/// Pictures of tiny scenes, pixel by pixel, without a window or a display.
class TestRenderer : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();
    void backgroundFillsAnEmptyScene();
    void skyIsBehindAnEmptyScene();
    void tintMultipliesTheSlotAlone();
    void tintHasAStrength();
    void replacingTintIsTheColourItself();
    void replacingTintKeepsTheShadesOfATexture();
    void slotsThatAreNotTintableKeepTheirColour();
    void hiddenPartIsNotDrawn();
    void materialChoiceIsPerIndividual();
    void peopleStandWhereTheyAre();
    void headingTurnsFromZTowardsX();
    void keyframesAreBlended();
    void seatedPeopleMeetTheirSeat();
    void stageHidesWhoIsBehind();
    void selectionIsAnOutlineThatKeepsTheColours();
    void outlineStaysWithinWhatIsSeen();
    void neighboursInASelectionAreApart();
    void hoveredHasAnOutlineOfItsOwn();
    void ghostShowsWhatIsBehind();
    void ringsAreHollowAndSharedByTheirParts();
    void ringsShineThroughPeople();
    void areasLeavePeopleAlone();
    void areasColourAPixelOnce();
    void hiddenAreasShineFaintly();
    void groundIsColouredWhereItIsSeen();
    void areasAreSentAgainWithAnotherVersion();
    void textureIsDrawnAsAuthored();
    void tintMaskLimitsTheTint();
    void cutOutTexelsAreNotDrawn();
    void samePictureTwice();
    void picturesAreOpaque();
    void onlyChangedRowsAreUploaded();
    void whoIsOutOfViewIsNotDrawn();
    void contextIsReplaced();

private:
    [[nodiscard]] render::RenderInput inputFor(const model::CrowdFramePtr& frame);
    [[nodiscard]] Rgb pixel(int x, int y) const;
    void drawMan(const model::Population& population, double seconds = 0.0);
    void drawAsset(const std::shared_ptr<model::Template>& asset, const model::Population& people);
};

void TestRenderer::initTestCase()
{
    open();
}

void TestRenderer::cleanupTestCase()
{
    m_renderer->destroy();
}

render::RenderInput TestRenderer::inputFor(const model::CrowdFramePtr& frame)
{
    render::RenderInput input(frontView(), *m_keyframes);
    input.frame = frame;
    input.look = render::Look::Plain;
    input.showGround = false;
    input.showShadows = false;
    input.background = {0.0F, 1.0F, 0.0F, 1.0F};
    return input;
}

void TestRenderer::drawMan(const model::Population& population, double seconds)
{
    draw(inputFor(frameOf(population, {entryFor(m_man)}, seconds)));
}

void TestRenderer::drawAsset(const std::shared_ptr<model::Template>& asset,
                             const model::Population& people)
{
    draw(inputFor(frameOf(people, {entryFor(asset)})));
}

Rgb TestRenderer::pixel(int x, int y) const
{
    const std::size_t at = (static_cast<std::size_t>(y) * 64 + static_cast<std::size_t>(x)) * 4;
    return {m_pixels[at], m_pixels[at + 1], m_pixels[at + 2]};
}

// Where the character is seen at 64 by 64 pixels: hat, body, legs.
constexpr int kMiddle = 32;
constexpr int kHatY = 18;
constexpr int kBodyY = 28;
constexpr int kLegsY = 40;
constexpr Rgb kGreen{0, 255, 0};

void TestRenderer::backgroundFillsAnEmptyScene()
{
    render::RenderInput input = inputFor(nullptr);
    input.background = {0.5F, 0.25F, 0.75F, 1.0F};
    draw(input);
    QVERIFY(isNear(pixel(0, 0), {128, 64, 191}, 1));
    QVERIFY(isNear(pixel(63, 63), {128, 64, 191}, 1));
}

void TestRenderer::skyIsBehindAnEmptyScene()
{
    render::RenderInput input = inputFor(nullptr);
    input.background = {};
    input.lighting.skyHorizon = {1.0F, 0.0F, 0.0F};
    input.lighting.skyZenith = {0.0F, 0.0F, 1.0F};
    draw(input);
    QVERIFY(isNear(pixel(kMiddle, 60), {255, 0, 0}));
    QVERIFY(pixel(kMiddle, 0).blue > 100);
    QVERIFY(pixel(kMiddle, 0).red < 255);
}

void TestRenderer::tintMultipliesTheSlotAlone()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::tint(1), model::Tint{255, 64, 0, 255});
    drawMan(people);
    QVERIFY(isNear(pixel(kMiddle, kBodyY), {255, 64, 0}));
    QVERIFY(isNear(pixel(kMiddle, kLegsY), {255, 255, 255}));
    QVERIFY(isNear(pixel(2, 2), kGreen));
}

void TestRenderer::tintHasAStrength()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::tint(0), model::Tint{0, 0, 0, 128});
    drawMan(people);
    // Half the light of white, encoded.
    QVERIFY(isNear(pixel(kMiddle, kLegsY), {188, 188, 188}));
}

void TestRenderer::replacingTintIsTheColourItself()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::materialChoices, model::MaterialChoices{0, 1}); // a blue top
    setAll(people, model::columns::tint(1), model::Tint{255, 64, 0, 255});
    drawMan(people);
    QVERIFY2(isNear(pixel(kMiddle, kBodyY), {0, 0, 0}), "orange times blue");
    setAll(people, model::columns::tintReplaces, std::uint16_t{2});
    drawMan(people);
    QVERIFY(isNear(pixel(kMiddle, kBodyY), {255, 64, 0}));
    QVERIFY(isNear(pixel(kMiddle, kLegsY), {255, 255, 255}));
    setAll(people, model::columns::tint(1), model::Tint{255, 64, 0, 0});
    drawMan(people);
    QVERIFY2(isNear(pixel(kMiddle, kBodyY), {0, 0, 255}), "no strength, no tint");
}

void TestRenderer::slotsThatAreNotTintableKeepTheirColour()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::tint(2), model::Tint{255, 0, 0, 255});
    drawMan(people);
    QVERIFY(isNear(pixel(kMiddle, kHatY), {124, 124, 124}));
}

void TestRenderer::hiddenPartIsNotDrawn()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::parts, 0U);
    drawMan(people);
    QVERIFY(isNear(pixel(kMiddle, kHatY), kGreen));
    QVERIFY(isNear(pixel(kMiddle, kBodyY), {255, 255, 255}));
}

void TestRenderer::materialChoiceIsPerIndividual()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::materialChoices, model::MaterialChoices{0, 1});
    drawMan(people);
    QVERIFY(isNear(pixel(kMiddle, kBodyY), {0, 0, 255}));
    QVERIFY(isNear(pixel(kMiddle, kLegsY), {255, 255, 255}));
}

void TestRenderer::peopleStandWhereTheyAre()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::position, glm::vec3(-1.0F, 0.0F, 0.0F));
    drawMan(people);
    QVERIFY(isNear(pixel(kMiddle, kBodyY), kGreen));
    QVERIFY(isNear(pixel(13, kBodyY), {255, 255, 255}));
}

void TestRenderer::headingTurnsFromZTowardsX()
{
    // A second character whose body sticks out to the front only.
    auto asset = makeBoxMan();
    asset->levels[0] = {};
    addBox(asset->levels[0], {-0.1F, 0.0F, 0.0F}, {0.1F, 1.8F, 0.8F}, 0);
    model::Population people = makeRow(1);
    setAll(people, model::columns::heading, 1.5707963F);
    drawAsset(asset, people);
    QVERIFY(isNear(pixel(kMiddle + 8, kBodyY), {255, 255, 255}));
    QVERIFY(isNear(pixel(kMiddle - 8, kBodyY), kGreen));
}

void TestRenderer::keyframesAreBlended()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::clip, std::uint16_t{1});
    setAll(people, model::columns::parts, 0U);
    setAll(people, model::columns::playbackSpeed, 1.0F);
    // The top edge rises a metre in 1.5 s; 19 pixels a metre at this distance.
    const auto topRow = [this] {
        for (int y = 0; y < 64; ++y) {
            if (!isNear(pixel(kMiddle, y), kGreen)) {
                return y;
            }
        }
        return 64;
    };
    drawMan(people, 0.0);
    const int atStart = topRow();
    drawMan(people, 0.2 / 32.0);
    QVERIFY(std::abs(topRow() - atStart) <= 1);
    drawMan(people, 0.7578125); // between keyframes 24 and 25: 0.505 m
    const int halfWay = topRow();
    QVERIFY2(std::abs(atStart - halfWay - 10) <= 1, qPrintable(QString::number(atStart - halfWay)));
}

void TestRenderer::seatedPeopleMeetTheirSeat()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::clip, std::uint16_t{2});
    setAll(people, model::columns::seat, model::SeatId{0x01000000});
    model::WorldSeat seat;
    seat.id = 0x01000000;
    seat.seat.height = 0.9F; // 0.4 m above the clip's own seat plane
    render::RenderInput input = inputFor(frameOf(people, {entryFor(m_man)}));
    draw(input);
    QVERIFY(!isNear(pixel(kMiddle, 47), kGreen)); // the foot of one who is not lifted
    input.seats = {&seat, 1};
    input.seatsVersion = 1;
    draw(input);
    QVERIFY(isNear(pixel(kMiddle, 47), kGreen));
    QVERIFY(isNear(pixel(kMiddle, 38), {255, 255, 255}));
}

void TestRenderer::stageHidesWhoIsBehind()
{
    auto stage = std::make_shared<model::StageAsset>();
    stage->materials.emplace_back();
    stage->materials[0].baseColor = {1.0F, 0.0F, 0.0F, 1.0F};
    model::StageMesh wall;
    wall.positions = {{-1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}};
    wall.normals.assign(4, glm::vec3(0, 0, 1));
    wall.uv.assign(4, glm::vec2(0));
    wall.indices = {0, 1, 2, 0, 2, 3};
    stage->meshes.push_back(wall);
    model::StageEntry entry;
    entry.asset = stage;
    entry.position = {0.0F, 0.0F, 1.0F};
    render::RenderInput input = inputFor(frameOf(makeRow(1), {entryFor(m_man)}));
    input.stages = {&entry, 1};
    draw(input);
    QVERIFY(isNear(pixel(kMiddle, kLegsY), {255, 0, 0}));
    QVERIFY(isNear(pixel(kMiddle, kHatY), {124, 124, 124}));
}

constexpr Rgb kSelection{255, 158, 26};

void TestRenderer::selectionIsAnOutlineThatKeepsTheColours()
{
    render::RenderInput input = inputFor(frameOf(makeRow(2), {entryFor(m_man)}));
    for (const int samples : {0, 4}) {
        input.samples = samples;
        input.selected = {};
        draw(input);
        const Rgb before = pixel(kMiddle, kBodyY);
        const int draws = m_renderer->statistics().draws;
        const std::array<model::IndividualId, 1> selected{1};
        input.selected = selected;
        draw(input);
        QVERIFY(isNear(pixel(kMiddle, kBodyY), before, 0));
        // Left of the legs, which end 6 pixels from the middle.
        QVERIFY(isNear(pixel(kMiddle - 7, kLegsY), kSelection));
        QVERIFY(isNear(pixel(kMiddle - 11, kLegsY), kGreen));
        QVERIFY2(m_renderer->statistics().draws == draws + 1, "people are drawn once");
        for (std::size_t i = 3; i < m_pixels.size(); i += 4) {
            QCOMPARE(static_cast<int>(m_pixels[i]), 255);
        }
    }
}

void TestRenderer::outlineStaysWithinWhatIsSeen()
{
    render::RenderInput input = inputFor(frameOf(makeRow(1), {entryFor(m_man)}));
    const std::array<model::IndividualId, 2> selected{1, 77}; // one is not there
    input.selected = selected;
    input.view = {model::Camera::lookingAt({0.0F, 0.9F, 0.9F}, {0.0F, 0.9F, -4.0F}),
                  glm::vec2(64.0F)};
    draw(input); // the picture is full of him: no rim at its border
    QVERIFY(isNear(pixel(1, kMiddle), pixel(kMiddle, kMiddle), 0));
    input.view = {model::Camera::lookingAt({0.0F, 0.9F, 4.0F}, {0.0F, 0.9F, 8.0F}),
                  glm::vec2(64.0F)};
    draw(input);
    QVERIFY(isNear(pixel(kMiddle, kMiddle), kGreen));
}

void TestRenderer::neighboursInASelectionAreApart()
{
    model::Population people = makeRow(2);
    const std::array<glm::vec3, 1> beside{glm::vec3(0.3F, 0.0F, -0.6F)};
    const std::array<model::IndividualId, 1> second{2};
    people.setValues(model::columns::position, second, std::span<const glm::vec3>(beside));
    render::RenderInput input = inputFor(frameOf(people, {entryFor(m_man)}));
    input.samples = 0;
    const std::array<model::IndividualId, 2> selected{1, 2};
    input.selected = selected;
    draw(input);
    int lines = 0;
    for (int x = kMiddle; x < kMiddle + 8; ++x) {
        lines += pixel(x, kLegsY).blue < 200 ? 1 : 0;
    }
    QVERIFY2(lines > 0, "a line where one stands before the other");
    QVERIFY(isNear(pixel(kMiddle - 2, kLegsY), {255, 255, 255}, 0));
}

void TestRenderer::hoveredHasAnOutlineOfItsOwn()
{
    render::RenderInput input = inputFor(frameOf(makeRow(1), {entryFor(m_man)}));
    const std::array<model::IndividualId, 1> selected{1};
    input.selected = selected;
    input.hovered = 1;
    draw(input);
    QVERIFY(isNear(pixel(kMiddle - 7, kLegsY), {255, 255, 255}));
    QVERIFY(isNear(pixel(kMiddle, kLegsY), {255, 255, 255}));
}

void TestRenderer::ghostShowsWhatIsBehind()
{
    render::Ghost ghost;
    ghost.asset = m_man;
    ghost.alpha = 0.5F;
    render::RenderInput input = inputFor(nullptr);
    input.ghosts = {&ghost, 1};
    draw(input);
    const Rgb through = pixel(kMiddle, kBodyY);
    QVERIFY(isNear(through, {188, 255, 188}));
}

/// A blue rectangle that faces the eye of frontView(), from the ground up, of half opacity.
std::array<render::OverlayTriangle, 2> blueSheet(float z, float alpha = 0.5F)
{
    const glm::vec4 color(0.0F, 0.0F, 1.0F, alpha);
    const glm::vec3 a(-2.0F, 0.0F, z);
    const glm::vec3 b(2.0F, 0.0F, z);
    const glm::vec3 c(2.0F, 2.0F, z);
    const glm::vec3 d(-2.0F, 2.0F, z);
    return {{{{a, b, c}, color}, {{a, c, d}, color}}};
}

void TestRenderer::ringsAreHollowAndSharedByTheirParts()
{
    render::RenderInput input = inputFor(nullptr);
    model::Camera above = model::Camera::lookingAt({0.0F, 4.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    above.projection = model::Projection::Orthographic;
    above.orthographicHeight = 2.0F;
    input.view = {above, glm::vec2(64.0F)};
    std::array<render::Marker, 2> parts{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].radius = 0.8F;
        parts[i].innerShare = 0.5F;
        parts[i].fromTurn = 0.5F * static_cast<float>(i);
        parts[i].toTurn = parts[i].fromTurn + 0.5F;
        parts[i].color =
            i == 0 ? glm::vec4(1.0F, 0.0F, 0.0F, 1.0F) : glm::vec4(0.0F, 0.0F, 1.0F, 1.0F);
    }
    input.markers = parts;
    draw(input);
    QVERIFY2(isNear(pixel(kMiddle, kMiddle), kGreen), "hollow");
    const Rgb left = pixel(kMiddle - 18, kMiddle);
    const Rgb right = pixel(kMiddle + 18, kMiddle);
    QVERIFY((isNear(left, {255, 0, 0}) && isNear(right, {0, 0, 255})) ||
            (isNear(left, {0, 0, 255}) && isNear(right, {255, 0, 0})));
    for (render::Marker& part : parts) {
        part.radius = 0.01F;
        part.leastPixels = 20.0F;
    }
    draw(input);
    QVERIFY2(!isNear(pixel(kMiddle + 14, kMiddle), kGreen), "still seen from far away");
    QVERIFY(isNear(pixel(kMiddle + 22, kMiddle), kGreen));
}

void TestRenderer::ringsShineThroughPeople()
{
    render::Marker ring;
    ring.position = {0.0F, 0.4F, -0.5F}; // behind the legs
    ring.radius = 0.6F;
    ring.innerShare = 0.2F;
    ring.color = {1.0F, 0.0F, 0.0F, 1.0F};
    render::RenderInput input = inputFor(frameOf(makeRow(1), {entryFor(m_man)}));
    input.view = {model::Camera::lookingAt({0.0F, 2.5F, 3.0F}, {0.0F, 0.7F, 0.0F}),
                  glm::vec2(64.0F)};
    draw(input);
    const std::vector<std::uint8_t> without = m_pixels;
    ring.innerShare = 0.0F;
    input.markers = {&ring, 1};
    draw(input);
    const auto reddened = [&] {
        int count = 0;
        for (std::size_t i = 0; i < m_pixels.size(); i += 4) {
            count += without[i + 2] == 255 && m_pixels[i + 2] < 240 ? 1 : 0;
        }
        return count;
    };
    QVERIFY2(reddened() == 0, "a disc does not");
    ring.innerShare = 0.2F;
    draw(input);
    QVERIFY(reddened() > 10);
}

void TestRenderer::areasLeavePeopleAlone()
{
    render::RenderInput input = inputFor(frameOf(makeRow(1), {entryFor(m_man)}));
    draw(input);
    const Rgb plain = pixel(kMiddle, kBodyY);
    const auto behind = blueSheet(-1.0F);
    input.areas = behind;
    draw(input);
    QVERIFY(isNear(pixel(kMiddle, kBodyY), plain));
    QVERIFY(pixel(kMiddle - 15, kBodyY).blue > 100);
    // Not even by what is a little nearer, as ground is to feet.
    const auto before = blueSheet(0.3F);
    input.areas = before;
    draw(input);
    QVERIFY(isNear(pixel(kMiddle, kBodyY), plain));
}

void TestRenderer::areasColourAPixelOnce()
{
    render::RenderInput input = inputFor(nullptr);
    const auto sheet = blueSheet(0.0F);
    input.areas = sheet;
    draw(input);
    const Rgb once = pixel(kMiddle, kBodyY);
    QVERIFY(once.blue > 150 && once.green > 150);
    std::vector<render::OverlayTriangle> many(sheet.begin(), sheet.end());
    const auto nearer = blueSheet(0.5F, 0.9F);
    many.insert(many.end(), nearer.begin(), nearer.end());
    input.areas = many;
    draw(input);
    QVERIFY(isNear(pixel(kMiddle, kBodyY), once)); // the first alone
}

/// Left of the middle, at z = 0.
model::StageEntry redWall()
{
    auto stage = std::make_shared<model::StageAsset>();
    stage->materials.emplace_back();
    stage->materials[0].baseColor = {1.0F, 0.0F, 0.0F, 1.0F};
    model::StageMesh wall;
    wall.positions = {{-3, 0, 0}, {0, 0, 0}, {0, 3, 0}, {-3, 3, 0}};
    wall.normals.assign(4, glm::vec3(0, 0, 1));
    wall.uv.assign(4, glm::vec2(0));
    wall.indices = {0, 1, 2, 0, 2, 3};
    stage->meshes.push_back(wall);
    model::StageEntry entry;
    entry.asset = stage;
    return entry;
}

void TestRenderer::hiddenAreasShineFaintly()
{
    const model::StageEntry entry = redWall();
    render::RenderInput input = inputFor(nullptr);
    input.stages = {&entry, 1};
    const auto sheet = blueSheet(-1.0F);
    input.areas = sheet;
    draw(input);
    const Rgb hidden = pixel(kMiddle - 10, kBodyY);
    const Rgb seen = pixel(kMiddle + 10, kBodyY);
    QVERIFY(hidden.red > 200 && hidden.blue > 30);
    QVERIFY(seen.blue > hidden.blue + 50);
    const auto sunk = blueSheet(-0.1F); // a little under the surface: seen all the same
    input.areas = sunk;
    draw(input);
    QVERIFY(pixel(kMiddle - 10, kBodyY).blue > hidden.blue + 50);
}

void TestRenderer::groundIsColouredWhereItIsSeen()
{
    const model::StageEntry entry = redWall();
    render::RenderInput input = inputFor(nullptr);
    input.stages = {&entry, 1};
    draw(input);
    const Rgb wall = pixel(kMiddle - 10, kBodyY);
    const auto behind = blueSheet(-0.3F);
    input.groundAreas = behind;
    draw(input);
    QVERIFY(isNear(pixel(kMiddle - 10, kBodyY), wall));
    QVERIFY(pixel(kMiddle + 10, kBodyY).blue > 100);
    const auto sunk = blueSheet(-0.05F);
    input.groundAreas = sunk;
    draw(input);
    QVERIFY(pixel(kMiddle - 10, kBodyY).blue > 100);
    auto above = blueSheet(-0.1F);
    for (render::OverlayTriangle& area : above) {
        area.color = {0.0F, 1.0F, 0.0F, 1.0F};
    }
    input.areas = above; // what is laid on the ground covers its colour
    draw(input);
    QVERIFY(isNear(pixel(kMiddle - 10, kBodyY), {0, 255, 0}));
}

void TestRenderer::areasAreSentAgainWithAnotherVersion()
{
    render::RenderInput input = inputFor(nullptr);
    auto sheet = blueSheet(0.0F);
    input.areas = sheet;
    input.areasVersion = 7;
    draw(input);
    QVERIFY(pixel(kMiddle, kBodyY).blue > 100);
    for (render::OverlayTriangle& area : sheet) {
        area.color = {1.0F, 0.0F, 0.0F, 1.0F};
    }
    draw(input);
    QVERIFY(pixel(kMiddle, kBodyY).blue > 100); // still what was sent
    input.areasVersion = 8;
    draw(input);
    QVERIFY(isNear(pixel(kMiddle, kBodyY), {255, 0, 0}));
}

/// Left half red, right half white; the same picture serves as mask.
std::shared_ptr<model::Template> texturedMan(model::AlphaMode alphaMode, bool hasMask)
{
    auto asset = makeBoxMan();
    model::Image image;
    image.width = 64;
    image.height = 64;
    image.rgba.resize(64 * 64 * 4, 255);
    model::Image mask = image;
    for (std::size_t i = 0; i < 64 * 64; ++i) {
        const bool isLeft = i % 64 < 32;
        image.rgba[i * 4 + 1] = isLeft ? 0 : 255;
        image.rgba[i * 4 + 2] = isLeft ? 0 : 255;
        image.rgba[i * 4 + 3] = alphaMode != model::AlphaMode::Opaque && isLeft ? 0 : 255;
        mask.rgba[i * 4] = isLeft ? 0 : 255;
    }
    asset->images = {image, mask};
    model::MaterialChoice& material = asset->slots[1].choices[0];
    material.image = 0;
    material.tintMask = hasMask ? 1 : -1;
    material.alphaMode = alphaMode;
    return asset;
}

void TestRenderer::textureIsDrawnAsAuthored()
{
    drawAsset(texturedMan(model::AlphaMode::Opaque, false), makeRow(1));
    QVERIFY(isNear(pixel(kMiddle - 3, kBodyY), {255, 0, 0}));
    QVERIFY(isNear(pixel(kMiddle + 3, kBodyY), {255, 255, 255}));
}

void TestRenderer::replacingTintKeepsTheShadesOfATexture()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::tint(1), model::Tint{0, 0, 255, 255});
    setAll(people, model::columns::tintReplaces, std::uint16_t{2});
    drawAsset(texturedMan(model::AlphaMode::Opaque, false), people);
    const Rgb dark = pixel(kMiddle - 3, kBodyY);
    const Rgb bright = pixel(kMiddle + 3, kBodyY);
    QVERIFY2(dark.red < 4 && bright.red < 4, "nothing of the texture's red and white is left");
    QVERIFY2(dark.blue > 100 && dark.blue < 200, qPrintable(QString::number(dark.blue)));
    QVERIFY2(bright.blue > 250, qPrintable(QString::number(bright.blue)));
    drawAsset(texturedMan(model::AlphaMode::Opaque, true), people);
    QVERIFY2(isNear(pixel(kMiddle - 3, kBodyY), {255, 0, 0}), "outside of the mask");
    QVERIFY(isNear(pixel(kMiddle + 3, kBodyY), {0, 0, 255}));
}

void TestRenderer::tintMaskLimitsTheTint()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::tint(1), model::Tint{0, 0, 255, 255});
    drawAsset(texturedMan(model::AlphaMode::Opaque, true), people);
    QVERIFY(isNear(pixel(kMiddle - 3, kBodyY), {255, 0, 0}));
    QVERIFY(isNear(pixel(kMiddle + 3, kBodyY), {0, 0, 255}));
}

void TestRenderer::cutOutTexelsAreNotDrawn()
{
    model::Population people = makeRow(1);
    setAll(people, model::columns::tint(1), model::Tint{0, 0, 255, 255});
    drawAsset(texturedMan(model::AlphaMode::Mask, true), people);
    QVERIFY(isNear(pixel(kMiddle - 3, kBodyY), kGreen));
    QVERIFY(isNear(pixel(kMiddle + 3, kBodyY), {0, 0, 255}));
}

void TestRenderer::samePictureTwice()
{
    render::RenderInput input = inputFor(frameOf(makeRow(3), {entryFor(m_man)}));
    input.look = render::Look::Lit;
    input.showGround = true;
    input.showShadows = true;
    draw(input);
    const std::vector<std::uint8_t> first = m_pixels;
    draw(input);
    QVERIFY(first == m_pixels);
}

void TestRenderer::picturesAreOpaque()
{
    render::Ghost ghost;
    ghost.asset = m_man;
    render::RenderInput input = inputFor(frameOf(makeRow(3), {entryFor(m_man)}));
    input.showShadows = true;
    input.showGround = true;
    input.background = {};
    input.ghosts = {&ghost, 1};
    draw(input);
    for (std::size_t i = 3; i < m_pixels.size(); i += 4) {
        QCOMPARE(static_cast<int>(m_pixels[i]), 255);
    }
}

void TestRenderer::onlyChangedRowsAreUploaded()
{
    model::Population people = makeRow(2000);
    const model::TemplateEntry entry = entryFor(m_man);
    const auto entries = std::make_shared<const std::vector<model::TemplateEntry>>(1, entry);
    const auto drawPeople = [&] {
        auto frame = std::make_shared<model::CrowdFrame>();
        frame->population = people;
        frame->templates = entries;
        draw(inputFor(frame));
        const auto drawn = m_renderer->draw(inputFor(frame));
        QVERIFY(drawn.isOk());
    };
    drawPeople();
    QCOMPARE(m_renderer->statistics().uploadedBytes, 0);
    const std::array<model::IndividualId, 2> changed{1, 700};
    const float heading = 1.0F;
    people.setValues(model::columns::heading, changed, std::span(&heading, 1));
    auto frame = std::make_shared<model::CrowdFrame>();
    frame->population = people;
    frame->templates = entries;
    QVERIFY(m_renderer->draw(inputFor(frame)).isOk());
    QCOMPARE(m_renderer->statistics().uploadedPlacements, 2);
    QCOMPARE(m_renderer->statistics().uploadedAppearances, 0);
    QCOMPARE(m_renderer->statistics().uploadedBytes, 64);
}

void TestRenderer::whoIsOutOfViewIsNotDrawn()
{
    drawMan(makeRow(100));
    QCOMPARE(m_renderer->statistics().individuals, 100);
    QVERIFY(m_renderer->statistics().visible >= 2);
    QVERIFY(m_renderer->statistics().visible <= 4);
}

void TestRenderer::contextIsReplaced()
{
    drawMan(makeRow(1));
    const std::vector<std::uint8_t> before = m_pixels;
    m_renderer->destroy();
    QVERIFY(!m_renderer->isInitialized());
    m_context.reset();
    auto context = render::OffscreenContext::create();
    QVERIFY(context.isOk());
    m_context = std::move(context).value();
    QVERIFY(m_renderer->initialize().isOk());
    drawMan(makeRow(1));
    QVERIFY(before == m_pixels);
}

CROWD_TEST(TestRenderer)
#include "tst_Renderer.moc"
