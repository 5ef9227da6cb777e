// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include <QtTest/QTest>

#include <glm/gtc/constants.hpp>

#include "model/bake/Impostor.h"
#include "model/gltf/GltfImport.h"
#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

constexpr int kCards = render::kImpostorLevel;
constexpr float kHuge = 1e6F;   ///< pixels: everybody is smaller
constexpr int kTurns = 8;       ///< that somebody is seen from
constexpr float kSide = 256.0F; ///< of a picture, pixels

/// What a picture shows before its green wall.
struct Seen
{
    int covered = 0; ///< pixels
    glm::dvec3 mean{0.0};
    glm::dvec2 middle{0.0};
};

Seen seenIn(const std::vector<std::uint8_t>& pixels, int width)
{
    Seen seen;
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        const glm::dvec3 color(pixels[i], pixels[i + 1], pixels[i + 2]);
        if (color != glm::dvec3(0.0, 255.0, 0.0)) {
            const auto at = static_cast<int>(i / 4);
            ++seen.covered;
            seen.mean += color;
            seen.middle += glm::dvec2(at % width, at / width);
        }
    }
    seen.mean /= std::max(seen.covered, 1);
    seen.middle /= std::max(seen.covered, 1);
    return seen;
}

} // namespace

/// Cards in place of triangles look like them.
class TestDrawnImpostors : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { open(); }
    void cleanupTestCase() { m_renderer->destroy(); }
    void cardsLookLikeTriangles_data();
    void cardsLookLikeTriangles();
    void cardsTakeTintsChoicesAndParts_data();
    void cardsTakeTintsChoicesAndParts();
    void everyLookDrawsThem_data();
    void everyLookDrawsThem();
    void builtInPeopleLookLikeThemselves_data();
    void builtInPeopleLookLikeThemselves();
    void theyHideWhatIsBehindThem();
    void theyCastShadowsAsTrianglesDo_data();
    void theyCastShadowsAsTrianglesDo();
    void whoIsHighlightedHasARim();
    void trianglesStandInWhileTheyAreBaked();
    void wiresAreOfTriangles();
    void placesAreOfTriangles();
    void whatHasNoneIsOfTriangles();

private:
    /// So many pixels high, from around and above (radians).
    [[nodiscard]] render::RenderInput from(float around, float above, float pixels,
                                           bool isPerspective = true);
    [[nodiscard]] Seen drawn(render::RenderInput input, float impostorPixels);
    /// How many times as much the cards cover.
    double compare(const render::RenderInput& input, double tolerance);

    model::TemplatePtr m_asset;
    model::Population m_people;
};

render::RenderInput TestDrawnImpostors::from(float around, float above, float pixels,
                                             bool isPerspective)
{
    const glm::vec3 middle(0.0F, m_asset->height * 0.5F, 0.0F);
    const glm::vec3 way(std::sin(around) * std::cos(above), std::sin(above),
                        std::cos(around) * std::cos(above));
    constexpr float kAway = 60.0F; // metres
    model::Camera camera = model::Camera::lookingAt(middle + way * kAway, middle);
    const float shownMetres = m_asset->height * kSide / pixels;
    camera.fovYRadians = 2.0F * std::atan(shownMetres * 0.5F / kAway);
    if (!isPerspective) {
        camera.projection = model::Projection::Orthographic;
        camera.orthographicHeight = shownMetres;
    }
    render::RenderInput input({camera, glm::vec2(kSide)}, *m_keyframes);
    input.frame = frameOf(m_people, {entryFor(m_asset)});
    input.showGround = false;
    input.showShadows = false;
    input.background = {0.0F, 1.0F, 0.0F, 1.0F};
    input.samples = 0;
    return input;
}

Seen TestDrawnImpostors::drawn(render::RenderInput input, float impostorPixels)
{
    input.levels = render::LevelThresholds::fullDetail();
    input.levels.impostorPixels = impostorPixels;
    draw(input);
    draw(input); // clips were there, now cards are
    return seenIn(m_pixels, m_renderer->size().x);
}

double TestDrawnImpostors::compare(const render::RenderInput& input, double tolerance)
{
    const Seen triangles = drawn(input, 0.0F);
    const int ofTriangles = m_renderer->statistics().byLevel[kCards];
    const Seen cards = drawn(input, kHuge);
    const int ofCards = m_renderer->statistics().byLevel[kCards];
    const double ratio = static_cast<double>(cards.covered) / std::max(triangles.covered, 1);
    const bool isAlike = triangles.covered > 200 && ofTriangles == 0 &&
                         ofCards == static_cast<int>(m_people.size()) &&
                         std::abs(ratio - 1.0) < tolerance &&
                         glm::distance(cards.mean, triangles.mean) < tolerance * 130.0 &&
                         glm::distance(cards.middle, triangles.middle) < 3.5;
    if (!isAlike) {
        const QString said =
            QStringLiteral(
                "%1 cards; they cover %2 times as much, %3 pixels away, %4 off in colour")
                .arg(ofCards)
                .arg(ratio)
                .arg(glm::distance(cards.middle, triangles.middle))
                .arg(glm::distance(cards.mean, triangles.mean));
        QTest::qFail(qPrintable(said), __FILE__, __LINE__);
    }
    return ratio;
}

void TestDrawnImpostors::cardsLookLikeTriangles_data()
{
    QTest::addColumn<float>("around");
    QTest::addColumn<float>("above");
    QTest::addColumn<bool>("isPerspective");
    for (const float around : {0.0F, 0.3F, 1.6F, 3.2F, 5.0F}) {
        for (const float above : {-0.3F, 0.0F, 0.2F, 0.5F, 0.9F, 1.4F}) {
            for (const bool isPerspective : {true, false}) {
                QTest::addRow("%g around, %g above, %s", static_cast<double>(around),
                              static_cast<double>(above), isPerspective ? "near" : "endless")
                    << around << above << isPerspective;
            }
        }
    }
}

void TestDrawnImpostors::cardsLookLikeTriangles()
{
    QFETCH(float, around);
    QFETCH(float, above);
    QFETCH(bool, isPerspective);
    m_asset = m_man;
    m_people = makeRow(1);
    setAll(m_people, model::columns::heading, 0.4F);
    setAll(m_people, model::columns::height, 1.1F);
    setAll(m_people, model::columns::girth, 0.9F);
    compare(from(around, above, 96.0F, isPerspective), 0.15);
}

void TestDrawnImpostors::cardsTakeTintsChoicesAndParts_data()
{
    QTest::addColumn<int>("change");
    QTest::newRow("tint") << 0;
    QTest::newRow("material choice") << 1;
    QTest::newRow("without a hat") << 2;
}

void TestDrawnImpostors::cardsTakeTintsChoicesAndParts()
{
    QFETCH(int, change);
    m_asset = m_man;
    m_people = makeRow(1);
    compare(from(0.3F, 0.2F, 96.0F), 0.15);
    const Seen before = drawn(from(0.3F, 0.2F, 96.0F), kHuge);
    if (change == 0) {
        setAll(m_people, model::columns::tint(0), model::Tint{200, 20, 20, 255});
    } else if (change == 1) {
        setAll(m_people, model::columns::materialChoices, model::MaterialChoices{0, 1});
    } else {
        setAll(m_people, model::columns::parts, 0U);
    }
    compare(from(0.3F, 0.2F, 96.0F), 0.15);
    const Seen after = drawn(from(0.3F, 0.2F, 96.0F), kHuge);
    QVERIFY(after.covered < before.covered || glm::distance(after.mean, before.mean) > 10.0);
}

void TestDrawnImpostors::everyLookDrawsThem_data()
{
    QTest::addColumn<int>("look");
    for (const render::LookInfo& look : render::kLooks) {
        if (look.look != render::Look::Wireframe) {
            QTest::newRow(look.key) << static_cast<int>(look.look);
        }
    }
}

void TestDrawnImpostors::everyLookDrawsThem()
{
    QFETCH(int, look);
    m_asset = m_man;
    m_people = makeRow(1);
    render::RenderInput input = from(0.6F, 0.3F, 96.0F);
    input.look = static_cast<render::Look>(look);
    model::Light lamp;
    lamp.id = 1;
    lamp.position = {2.0F, 4.0F, 3.0F};
    const std::vector<model::Light> lights{lamp};
    input.lights = lights;
    compare(input, 0.15);
}

void TestDrawnImpostors::builtInPeopleLookLikeThemselves_data()
{
    QTest::addColumn<QString>("file");
    const QDir folder(QStringLiteral(CROWD_RESOURCES "/templates"));
    const QStringList files = folder.entryList({QStringLiteral("*.glb")}, QDir::Files);
    QVERIFY(!files.isEmpty());
    for (const QString& file : files) {
        QTest::newRow(qPrintable(file)) << folder.filePath(file);
    }
}

void TestDrawnImpostors::builtInPeopleLookLikeThemselves()
{
    QFETCH(QString, file);
    auto imported = model::importTemplate(file.toStdString());
    QVERIFY(imported.isOk());
    m_asset = imported.value();
    m_people = makeRow(1);
    setAll(m_people, model::columns::parts, ~0U);
    setAll(m_people, model::columns::clip,
           static_cast<std::uint16_t>(m_asset->clips.size() > 2 ? 2 : 0));
    const model::Tint red{220, 30, 40, 255};
    for (std::size_t slot = 0; slot < m_asset->slots.size() && slot < 8; slot += 2) {
        setAll(m_people, model::columns::tint(static_cast<int>(slot)), red);
    }
    const render::RenderInput input = from(0.0F, 0.2F, 96.0F);
    (void)drawn(input, kHuge);
    const model::BakedClipPtr clip =
        m_keyframes->clip(m_asset, m_people.column(model::columns::clip)[0]).clip;
    if (model::impostorLayout(*m_asset, m_people.column(model::columns::clip)[0], *clip, 2)
            .isEmpty()) { // far wider than high
        QCOMPARE(m_renderer->statistics().byLevel[kCards], 0);
        return;
    }
    double covered = 0.0;
    for (int turn = 0; turn < kTurns; ++turn) {
        covered += compare(from(static_cast<float>(turn) * 0.83F, 0.2F, 96.0F), 0.25) / kTurns;
        if (QTest::currentTestFailed()) {
            return;
        }
    }
    QVERIFY2(std::abs(covered - 1.0) < 0.06, qPrintable(QString::number(covered)));
}

/// Of two who stand in each other the nearer parts are seen, as of triangles.
void TestDrawnImpostors::theyHideWhatIsBehindThem()
{
    m_asset = m_man;
    m_people = makeRow(2);
    const std::vector<glm::vec3> places{{0.0F, 0.0F, 0.0F}, {0.25F, 0.0F, 0.1F}};
    m_people.setValues<glm::vec3>(model::columns::position, m_people.ids(), places);
    const std::vector<model::IndividualId> second{2};
    const std::vector<model::Tint> dark{{0, 0, 0, 255}};
    m_people.setValues<model::Tint>(model::columns::tint(0), second, dark);
    m_people.setValues<model::Tint>(model::columns::tint(1), second, dark);
    compare(from(0.0F, 0.2F, 96.0F), 0.1);
    compare(from(3.1F, 0.2F, 96.0F), 0.1);
    // And a wall between them and the eye hides them.
    render::RenderInput input = from(0.0F, 0.0F, 96.0F);
    model::StageEntry wall;
    wall.asset = makeSheet(
        {{{-9.0F, -9.0F, 1.0F}, {9.0F, -9.0F, 1.0F}, {9.0F, 9.0F, 1.0F}, {-9.0F, 9.0F, 1.0F}}});
    const std::vector<model::StageEntry> stages{wall};
    input.stages = stages;
    (void)drawn(input, kHuge);
    const std::set<std::uint8_t> reds{m_pixels.begin(), m_pixels.end()};
    (void)drawn(input, 0.0F);
    const std::set<std::uint8_t> same{m_pixels.begin(), m_pixels.end()};
    QVERIFY(reds == same);
}

void TestDrawnImpostors::theyCastShadowsAsTrianglesDo_data()
{
    QTest::addColumn<float>("azimuth");
    QTest::addColumn<float>("elevation");
    for (const float azimuth : {1.1F, 2.5F, 4.4F}) {
        for (const float elevation : {0.25F, 0.5F, 0.9F}) {
            QTest::addRow("%g around, %g above", static_cast<double>(azimuth),
                          static_cast<double>(elevation))
                << azimuth << elevation;
        }
    }
}

/// Also where people are too near to be cards themselves: nobody is in the shadow of his own card.
/// From beside: seen along the light a shadow is but a rim, which half a texel makes twice as wide.
void TestDrawnImpostors::theyCastShadowsAsTrianglesDo()
{
    QFETCH(float, azimuth);
    QFETCH(float, elevation);
    constexpr int kPeople = 9;
    m_asset = m_man;
    m_people = makeRow(kPeople);
    std::vector<glm::vec3> places;
    for (int i = 0; i < kPeople; ++i) {
        const glm::vec2 cell(i % 3 - 1, i / 3 - 1);
        places.emplace_back(cell.x * 16.0F, 0.0F, cell.y * 16.0F);
    }
    m_people.setValues<glm::vec3>(model::columns::position, m_people.ids(), places);
    render::RenderInput input = from(0.3F, 1.0F, 11.0F);
    input.showGround = true;
    input.showShadows = true;
    input.lighting.showGroundGrid = false;
    input.lighting.sunAzimuthRadians = azimuth;
    input.lighting.sunElevationRadians = elevation;
    input.lighting.shadowStrength = 1.0F;
    const auto mean = [&](float impostorPixels) {
        (void)drawn(input, impostorPixels);
        double sum = 0.0;
        for (std::size_t i = 0; i < m_pixels.size(); i += 4) {
            sum += m_pixels[i + 1];
        }
        return sum / (static_cast<double>(m_pixels.size()) / 4.0);
    };
    const double ofTriangles = mean(0.0F);
    const auto drawnTriangles = m_renderer->statistics().triangles;
    constexpr float kTiny = 1e-3F; // nobody is a card but in the shadow map
    const double ofCards = mean(kTiny);
    QCOMPARE(m_renderer->statistics().byLevel[kCards], 0);
    QVERIFY(m_renderer->statistics().triangles < drawnTriangles);
    input.showShadows = false;
    const double shadowed = mean(0.0F) - ofTriangles;
    QVERIFY2(shadowed > 0.1, qPrintable(QString::number(shadowed)));
    const double off = std::abs(ofCards - ofTriangles) / shadowed;
    QVERIFY2(off < 0.2, qPrintable(QString::number(off)));
}

void TestDrawnImpostors::whoIsHighlightedHasARim()
{
    m_asset = m_man;
    m_people = makeRow(1);
    const std::vector<model::IndividualId> selected{1};
    render::RenderInput input = from(0.4F, 0.2F, 96.0F);
    input.selected = selected;
    input.selectionColor = {1.0F, 0.0F, 1.0F};
    const auto rim = [&](float impostorPixels) {
        (void)drawn(input, impostorPixels);
        int pixels = 0;
        for (std::size_t i = 0; i < m_pixels.size(); i += 4) {
            pixels += m_pixels[i] > 200 && m_pixels[i + 1] < 60 && m_pixels[i + 2] > 200 ? 1 : 0;
        }
        return pixels;
    };
    const int ofTriangles = rim(0.0F);
    const int ofCards = rim(kHuge);
    QVERIFY(ofTriangles > 30);
    QVERIFY2(std::abs(ofCards - ofTriangles) < ofTriangles / 4,
             qPrintable(QString::number(ofCards)));
}

void TestDrawnImpostors::trianglesStandInWhileTheyAreBaked()
{
    m_asset = makeBoxMan(); // whose cards nobody has
    m_people = makeRow(1);
    render::RenderInput input = from(0.4F, 0.2F, 96.0F);
    input.levels.impostorPixels = kHuge;
    QVERIFY(m_renderer->draw(input).isOk());
    QCOMPARE(m_renderer->statistics().byLevel[kCards], 0);
    QCOMPARE(m_renderer->statistics().visible, 1);
    m_keyframes->waitForAll();
    QVERIFY(m_renderer->draw(input).isOk());
    QCOMPARE(m_renderer->statistics().byLevel[kCards], 1);
}

void TestDrawnImpostors::wiresAreOfTriangles()
{
    m_asset = m_man;
    m_people = makeRow(1);
    render::RenderInput input = from(0.4F, 0.2F, 96.0F);
    input.look = render::Look::Wireframe;
    (void)drawn(input, kHuge);
    QCOMPARE(m_renderer->statistics().byLevel[kCards], 0);
}

/// What people work on with afterwards is exact.
void TestDrawnImpostors::placesAreOfTriangles()
{
    m_asset = m_man;
    m_people = makeRow(1);
    render::RenderInput input = from(0.4F, 0.2F, 96.0F);
    (void)drawn(input, kHuge);
    input.levels.impostorPixels = kHuge;
    QVERIFY(m_renderer->drawAovs(input).isOk());
    QCOMPARE(m_renderer->statistics().byLevel[kCards], 0);
    QCOMPARE(m_renderer->statistics().visible, 1);
}

void TestDrawnImpostors::whatHasNoneIsOfTriangles()
{
    const auto veiled = makeBoxMan();
    veiled->slots[0].choices[0].alphaMode = model::AlphaMode::Blend;
    m_asset = veiled;
    m_people = makeRow(1);
    const Seen seen = drawn(from(0.4F, 0.2F, 96.0F), kHuge);
    QCOMPARE(m_renderer->statistics().byLevel[kCards], 0);
    QVERIFY(seen.covered > 20);
}

CROWD_TEST(TestDrawnImpostors)
#include "tst_DrawnImpostors.moc"
