// SPDX-License-Identifier: MIT
#include <array>
#include <map>

#include <QtCore/QDir>
#include <QtTest/QTest>
#include <epoxy/egl.h>

#include "app/commands/SceneSource.h"
#include "app/pictures/PictureMaker.h"
#include "model/scene/ReadyLight.h"
#include "model/view/PropertyPaint.h"
#include "tests/images/ComparePictures.h"
#include "tests/program/Test.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

/// Whole pictures against ones that somebody has looked at, tests/data/pictures/NAME.png. Where one
/// differs, the new one is left in pictures-that-differ beside the test programs. When it is right:
/// CROWD_ACCEPT_PICTURES=1 makes the test write them into the source tree instead.
class tst_Pictures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void looksAsBefore_data();
    void looksAsBefore();
    void seesWhatPeopleSee_data();
    void seesWhatPeopleSee();
    void overlooksWhatDriversDo_data();
    void overlooksWhatDriversDo();
    void tilesLookLikeTheWhole_data();
    void tilesLookLikeTheWhole();
    void aPictureDoesNotDependOnThoseBefore_data();
    void aPictureDoesNotDependOnThoseBefore();
    void aContextThatIsLostIsMadeAgain();

private:
    [[nodiscard]] QImage draw(const model::Scene& scene, const char* camera = "",
                              render::Look look = render::Look::Lit, int scale = 1,
                              int tileSide = 2016);

    model::KeyframeStore m_keyframes;
    std::unique_ptr<app::PictureMaker> m_maker;
};

namespace {

constexpr glm::ivec2 kSize{320, 180};
constexpr double kSeconds = 0.4;

model::Scene loaded(const char* file)
{
    auto scene = app::loadForPicture(QStringLiteral(CROWD_RESOURCES) + QLatin1String(file));
    if (!scene) {
        qFatal("%s", scene.error().message.c_str());
    }
    return std::move(scene).value();
}

template<class T>
void setOne(model::Scene& scene, model::IndividualId id, model::ColumnKey<T> key, const T& value)
{
    scene.population.setValues(key, std::span(&id, 1), std::span<const T>(&value, 1));
}

/// Seven people of boxes with tints of their own, some without a hat, on the empty ground.
model::Scene boxPeople()
{
    model::Scene scene;
    const auto man = makeBoxMan();
    for (model::Slot& slot : man->slots) {
        for (model::MaterialChoice& choice : slot.choices) {
            choice.roughness = 0.3F;
        }
    }
    scene.templates = {entryFor(man)};
    scene.population = makeRow(7);
    for (model::IndividualId id = 1; id <= 7; ++id) {
        const auto level = static_cast<std::uint8_t>(30 * id);
        const auto rest = static_cast<std::uint8_t>(255 - level);
        setOne(scene, id, model::columns::tint(0), model::Tint{90, 60, level, 255});
        setOne(scene, id, model::columns::tint(1), model::Tint{level, rest, 90, 255});
        setOne(scene, id, model::columns::heading, 0.5F * static_cast<float>(id));
        setOne(scene, id, model::columns::parts, id % 3 == 0 ? 0U : 1U);
        setOne(scene, id, model::columns::tags, std::uint64_t{1} << id % 3U);
    }
    scene.cameras.push_back(
        {"front", model::Camera::lookingAt({5.0F, 3.0F, 7.0F}, {3.0F, 0.8F, 0.0F})});
    return scene;
}

/// From the left of the row of people, onto the third of them.
model::Light lampOn(model::LightKind kind)
{
    model::Light light;
    light.id = 1;
    light.kind = kind;
    light.color = {255, 190, 120};
    light.position =
        kind == model::LightKind::Spot ? glm::vec3(-1.0F, 5.0F, 4.0F) : glm::vec3(3.5F, 2.6F, 1.2F);
    light.target = {2.0F, 1.0F, 0.0F};
    light.strength = kind == model::LightKind::Spot ? 0.9F : 0.15F;
    light.castsShadows = true;
    light.beam = 0.5F;
    return light;
}

/// The same people at another time of day, in mist, or at night in the light of a lamp.
void lightUp(model::Scene& scene, const QString& light)
{
    if (light == QLatin1String("mist")) {
        scene.lighting = model::findReadyLight("dusk")->light;
        scene.lighting.haze = 0.98F;
        scene.lighting.hazeHeight = 1.0F;
    } else if (light == QLatin1String("spot") || light == QLatin1String("point")) {
        const bool isSpot = light == QLatin1String("spot");
        scene.lighting = model::findReadyLight("night")->light;
        scene.lights = {lampOn(isSpot ? model::LightKind::Spot : model::LightKind::Point)};
    } else if (!light.isEmpty()) {
        scene.lighting = model::findReadyLight(light.toStdString())->light;
    }
}

/// See seesWhatPeopleSee_data.
void changeOneThing(model::Scene& scene, int change)
{
    const std::array<model::IndividualId, 1> one{4};
    switch (change) {
    case 0:
        (void)scene.population.remove(one);
        break;
    case 1:
        setOne(scene, 4, model::columns::tint(1), model::Tint{200, 60, 60, 255});
        break;
    case 2:
        setAll(scene.population, model::columns::tint(0), model::Tint{70, 90, 120, 255});
        break;
    case 3:
        scene.lighting.sunStrength *= 0.85F;
        break;
    case 4:
        scene.lighting.ambientStrength = 0.0F;
        break;
    case 5:
        setOne(scene, 3, model::columns::parts, 1U);
        break;
    case 7:
        scene.lighting.sunAzimuthRadians += 0.4F;
        break;
    case 8:
        scene.lighting.shadowStrength = 0.0F;
        break;
    case 9:
        (void)scene.population.remove(one);
        break;
    case 10:
        scene.lighting.highlights = 0.0F;
        break;
    case 11:
    case 12:
        scene.lights[0].position.x += 0.8F;
        scene.lights[0].target.x += 0.8F;
        break;
    case 13:
        scene.lights[0].castsShadows = false;
        break;
    case 14:
        scene.lighting.haze = 0.9F;
        break;
    case 15:
        scene.lighting.hazeHeight = 0.0F;
        break;
    default:
        setOne(scene, 4, model::columns::heading, 0.5F);
        break;
    }
}

QString accepted(const QString& name)
{
    return QStringLiteral(CROWD_TEST_DATA "/pictures/") + name + QStringLiteral(".png");
}

QString told(const PictureDifference& difference)
{
    return QStringLiteral("differs by %1 everywhere, by %2 around pixel %3, %4")
        .arg(difference.shift, 0, 'f', 2)
        .arg(difference.worst, 0, 'f', 1)
        .arg(difference.x)
        .arg(difference.y);
}

} // namespace

void tst_Pictures::initTestCase()
{
    auto maker = app::PictureMaker::create(m_keyframes);
    QVERIFY2(maker.isOk(), maker ? "" : maker.error().message.c_str());
    m_maker = std::move(maker).value();
}

QImage tst_Pictures::draw(const model::Scene& scene, const char* camera, render::Look look,
                          int scale, int tileSide)
{
    const std::vector<model::WorldSeat> seats = scene.worldSeats();
    app::PictureRequest request;
    auto frame = std::make_shared<model::CrowdFrame>();
    frame->population = scene.population;
    frame->templates = std::make_shared<const std::vector<model::TemplateEntry>>(scene.templates);
    frame->seconds = kSeconds;
    request.frame = frame;
    request.stages = scene.stages;
    request.seats = seats;
    static std::uint64_t version = 0;
    request.seatsVersion = ++version;
    request.lighting = scene.lighting;
    request.lights = scene.lights;
    if (render::lookInfo(look).isByProperty) {
        request.frame = model::framePaintedBy(scene, *frame, "tag");
    }
    const auto found = std::ranges::find(scene.cameras, camera, &model::NamedCamera::name);
    request.camera = (found == scene.cameras.end() ? scene.cameras.front() : *found).camera;
    request.size = kSize * scale;
    request.look = look;
    request.tileSide = tileSide;
    const auto drawn = m_maker->draw(request);
    if (!drawn) {
        qFatal("%s", drawn.error().message.c_str());
    }
    const std::vector<std::uint8_t> pixels = m_maker->pixels();
    return QImage(pixels.data(), request.size.x, request.size.y, request.size.x * 4,
                  QImage::Format_RGBX8888)
        .convertToFormat(QImage::Format_RGB888);
}

void tst_Pictures::looksAsBefore_data()
{
    QTest::addColumn<QString>("scene");
    QTest::addColumn<QString>("camera");
    QTest::addColumn<int>("look");
    QTest::addColumn<QString>("light");
    const int lit = static_cast<int>(render::Look::Lit);
    const QString theatre = QStringLiteral("/scenes/theatre.crowd");
    QTest::newRow("theatre_audience") << theatre << QStringLiteral("Audience") << lit << QString();
    QTest::newRow("theatre_close") << theatre << QStringLiteral("Close") << lit << QString();
    for (const char* name : {"city", "meadow", "stadium"}) {
        QTest::newRow(name) << QStringLiteral("/scenes/%1.crowd").arg(QLatin1String(name))
                            << QString() << lit << QString();
    }
    QTest::newRow("stage_alone") << QStringLiteral("/stages/theatre.glb") << QString() << lit
                                 << QString();
    QTest::newRow("man") << QStringLiteral("/templates/man.glb") << QString() << lit << QString();
    QTest::newRow("box_people") << QString() << QString() << lit << QString();
    for (const render::LookInfo& look : render::kLooks) {
        if (look.look != render::Look::Lit) {
            QTest::addRow("box_people_%s", look.key)
                << QString() << QString() << static_cast<int>(look.look) << QString();
        }
    }
    for (const model::ReadyLight& light : model::readyLights()) {
        QTest::addRow("box_people_%s", light.key)
            << QString() << QString() << lit << QString::fromLatin1(light.key);
    }
    for (const char* light : {"spot", "point", "mist"}) {
        QTest::addRow("box_people_%s", light)
            << QString() << QString() << lit << QString::fromLatin1(light);
    }
}

void tst_Pictures::looksAsBefore()
{
    QFETCH(const QString, scene);
    QFETCH(const QString, camera);
    QFETCH(const int, look);
    QFETCH(const QString, light);
    const QString name = QString::fromLatin1(QTest::currentDataTag());
    model::Scene shown = scene.isEmpty() ? boxPeople() : loaded(scene.toUtf8().constData());
    lightUp(shown, light);
    const QImage picture =
        draw(shown, camera.toUtf8().constData(), static_cast<render::Look>(look));
    if (qEnvironmentVariableIsSet("CROWD_ACCEPT_PICTURES")) {
        QVERIFY(picture.save(accepted(name)));
        QSKIP("The picture is accepted as it is now.");
    }
    const QImage before(accepted(name));
    QCOMPARE(picture.size(), before.size());
    const PictureDifference difference = comparePictures(before, picture);
    if (difference.isVisible()) {
        const QDir folder(QCoreApplication::applicationDirPath() +
                          QStringLiteral("/pictures-that-differ"));
        QVERIFY(folder.mkpath(QStringLiteral(".")));
        const QString now = folder.filePath(name + QStringLiteral(".png"));
        QVERIFY(picture.save(now));
        QFAIL(
            qPrintable(now + u' ' + told(difference) +
                       QStringLiteral(". Look at it; if it is right, run this test with "
                                      "CROWD_ACCEPT_PICTURES=1 and commit tests/data/pictures.")));
    }
}

void tst_Pictures::seesWhatPeopleSee_data()
{
    QTest::addColumn<int>("change");
    QTest::newRow("a person too few") << 0;
    QTest::newRow("another tint of one slot") << 1;
    QTest::newRow("another tint of all") << 2;
    QTest::newRow("less sun") << 3;
    QTest::newRow("no ambient light") << 4;
    QTest::newRow("a hat too many") << 5;
    QTest::newRow("a person turned round") << 6;
    QTest::newRow("a sun elsewhere") << 7;
    QTest::newRow("no shadows") << 8;
    QTest::newRow("a caster too few, who is out of the picture") << 9;
    QTest::newRow("no highlights") << 10;
    QTest::newRow("a spotlight elsewhere") << 11;
    QTest::newRow("a light to all sides a bit elsewhere") << 12;
    QTest::newRow("no shadows of a spotlight") << 13;
    QTest::newRow("less mist") << 14;
    QTest::newRow("mist that does not lie low") << 15;
}

void tst_Pictures::seesWhatPeopleSee()
{
    QFETCH(const int, change);
    model::Scene scene = boxPeople();
    if (change == 9) { // between the others and the sun, behind the camera
        setOne(scene, 4, model::columns::position, glm::vec3(5.2F, 0.0F, 9.0F));
        setOne(scene, 4, model::columns::height, 2.4F);
        scene.lighting.sunAzimuthRadians = 0.1F;
        scene.lighting.sunElevationRadians = 0.5F;
    }
    static const std::map<int, const char*> lights{
        {11, "spot"}, {12, "point"}, {13, "spot"}, {14, "mist"}, {15, "mist"}};
    if (const auto light = lights.find(change); light != lights.end()) {
        lightUp(scene, QLatin1String(light->second));
    }
    scene.lighting.highlights = change == 10 ? 2.0F : 1.0F;
    const QImage before = draw(scene);
    changeOneThing(scene, change);
    const PictureDifference difference = comparePictures(before, draw(scene));
    QVERIFY2(difference.isVisible(), qPrintable(told(difference)));
}

void tst_Pictures::tilesLookLikeTheWhole_data()
{
    QTest::addColumn<int>("look");
    QTest::addColumn<QString>("light");
    QTest::addColumn<bool>("isFlat");
    for (const render::LookInfo& look : render::kLooks) {
        QTest::newRow(look.key) << static_cast<int>(look.look) << QString() << false;
    }
    const int lit = static_cast<int>(render::Look::Lit);
    for (const char* light : {"spot", "point", "mist"}) {
        QTest::newRow(light) << lit << QString::fromLatin1(light) << false;
    }
    QTest::newRow("orthographic") << lit << QString() << true;
    QTest::newRow("orthographic, with lines")
        << static_cast<int>(render::Look::Cartoon) << QString() << true;
}

/// Nowhere is a seam: what rounds differently is a step or two.
void tst_Pictures::tilesLookLikeTheWhole()
{
    QFETCH(const int, look);
    QFETCH(const QString, light);
    QFETCH(const bool, isFlat);
    model::Scene scene = boxPeople();
    lightUp(scene, light);
    if (isFlat) {
        scene.cameras.front().camera.projection = model::Projection::Orthographic;
        scene.cameras.front().camera.orthographicHeight = 4.0F;
    }
    const auto used = static_cast<render::Look>(look);
    const QImage whole = draw(scene, "", used, 2);
    const QImage tiles = draw(scene, "", used, 2, 120);
    const PictureDifference difference = comparePictures(whole, tiles);
    QVERIFY2(std::abs(difference.shift) < 0.05 && difference.worst < 6.0,
             qPrintable(told(difference)));
}

void tst_Pictures::overlooksWhatDriversDo_data()
{
    QTest::addColumn<bool>("isNoise");
    QTest::newRow("other smoothing of edges") << false;
    QTest::newRow("other rounding") << true;
}

void tst_Pictures::overlooksWhatDriversDo()
{
    QFETCH(const bool, isNoise);
    std::vector<model::Scene> scenes{boxPeople()};
    if (isNoise) { // of a full theatre the larger picture shows finer detail levels, rightly
        scenes.push_back(loaded("/scenes/theatre.crowd"));
    }
    for (const model::Scene& scene : scenes) {
        const QImage before = draw(scene);
        QImage other = before;
        if (isNoise) {
            for (int y = 0; y < other.height(); ++y) {
                for (int i = 0; i < other.width() * 3; ++i) {
                    uchar& value = other.scanLine(y)[i];
                    const int step = (i * 7 + y * 13) % 5 - 2;
                    value = static_cast<uchar>(std::clamp(int{value} + step, 0, 255));
                }
            }
        } else {
            // Twice as large and made smaller: sixteen samples a pixel instead of four.
            other = draw(scene, "", render::Look::Lit, 2)
                        .scaled(kSize.x, kSize.y, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        }
        const PictureDifference difference = comparePictures(before, other);
        QVERIFY2(!difference.isVisible(), qPrintable(told(difference)));
    }
}

namespace {

/// Two templates of which `id` has people, who are in a clip and some of them come from another.
model::CrowdFramePtr framed(const std::vector<model::TemplateEntry>& entries, model::TemplateId id,
                            std::uint16_t clip, bool isFading)
{
    auto frame = std::make_shared<model::CrowdFrame>(*frameOf(makeRow(5), entries, 0.7));
    for (model::IndividualId each = 1; each <= 5; ++each) {
        frame->population.setValues(model::columns::templateId, std::span(&each, 1),
                                    std::span<const model::TemplateId>(&id, 1));
        frame->population.setValues(model::columns::clip, std::span(&each, 1),
                                    std::span<const std::uint16_t>(&clip, 1));
    }
    if (isFading) {
        frame->fades = {{0, 1, 0.5F, 0.3F}, {3, 1, 0.25F, 0.6F}};
    }
    return frame;
}

std::vector<std::uint8_t> lastOf(const std::vector<model::CrowdFramePtr>& frames,
                                 std::size_t budget)
{
    model::KeyframeStore keyframes(budget);
    auto maker = app::PictureMaker::create(keyframes);
    if (!maker) {
        qFatal("%s", maker.error().message.c_str());
    }
    for (const model::CrowdFramePtr& frame : frames) {
        app::PictureRequest request;
        request.frame = frame;
        request.camera = model::Camera::lookingAt({5.0F, 3.0F, 7.0F}, {3.0F, 0.8F, 0.0F});
        request.size = kSize;
        if (const auto drawn = maker.value()->draw(request); !drawn) {
            qFatal("%s", drawn.error().message.c_str());
        }
    }
    return maker.value()->pixels();
}

} // namespace

void tst_Pictures::aPictureDoesNotDependOnThoseBefore_data()
{
    QTest::addColumn<bool>("isFading"); ///< from a clip that nobody is in any more
    QTest::addColumn<qulonglong>("budget");
    QTest::newRow("clips of another template") << false << qulonglong{100'000'000};
    QTest::newRow("clips that leave no room") << false << qulonglong{60'000};
    QTest::newRow("clips that people come from") << true << qulonglong{100'000'000};
}

void tst_Pictures::aPictureDoesNotDependOnThoseBefore()
{
    QFETCH(const bool, isFading);
    QFETCH(const qulonglong, budget);
    const std::vector<model::TemplateEntry> entries{entryFor(makeBoxMan(), 1),
                                                    entryFor(makeBoxMan(), 2)};
    const model::CrowdFramePtr before = framed(entries, isFading ? 2 : 1, 1, false);
    const model::CrowdFramePtr wanted = framed(entries, 2, isFading ? 0 : 1, isFading);
    const auto alone = lastOf({wanted}, budget);
    QVERIFY(alone != lastOf({framed(entries, 2, 0, false)}, budget)); // it moves
    QVERIFY(lastOf({before, wanted}, budget) == alone);
    QVERIFY(lastOf({before, before, wanted, before, wanted}, budget) == alone);
}

/// As by a driver that was reset.
void tst_Pictures::aContextThatIsLostIsMadeAgain()
{
    const model::Scene scene = boxPeople();
    const QImage before = draw(scene);
    EGLDisplay display = eglGetCurrentDisplay();
    EGLContext context = eglGetCurrentContext();
    QVERIFY(context != EGL_NO_CONTEXT);
    QVERIFY(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT) == EGL_TRUE);
    QVERIFY(eglDestroyContext(display, context) == EGL_TRUE);
    QVERIFY(draw(scene) == before);
}

CROWD_TEST(tst_Pictures)
#include "tst_Pictures.moc"
