// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <string>

#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QTemporaryDir>
#include <QtGui/QColor>
#include <QtGui/QImage>
#include <QtTest/QTest>

#include "app/pictures/PassFile.h"
#include "app/pictures/PictureFile.h"
#include "app/pictures/PictureMaker.h"
#include "app/pictures/PicturePasses.h"
#include "model/base/Color.h"
#include "model/scene/Scene.h"
#include "tests/images/ExrReading.h"
#include "tests/program/Test.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

/// Layers of pictures, as other programs find them in the file.
class TestPicturePasses : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theyAreFoundByName();
    void coloursAreLinear();
    void theFileTellsWhoIsWhere();
    void coloursGoBeyondWhite();
    void motionIsThere();
    void mattesHaveSmoothEdges();
    void manyOfAPixelKeepTheirTemplates();
    void matteNumbersAreThoseOfOthers();
    void twoRunsAreTheSame();
    void eachCanBeAPng();
    void whatIsThereAlreadyIsLookedAt();
    void whatCannotBeWrittenIsSaid();

private:
    QTemporaryDir m_folder;
};

void TestPicturePasses::theyAreFoundByName()
{
    const auto passes = app::passesOf("id,depth,colour,depth");
    QVERIFY(passes.isOk());
    QCOMPARE(passes.value().size(), std::size_t{3});
    QCOMPARE(passes.value()[0]->key, std::string_view("colour"));
    QCOMPARE(passes.value()[2]->key, std::string_view("id"));
    QCOMPARE(app::passesOf(" depth, id ").value().size(), std::size_t{2});
    QVERIFY(app::passesOf("").isOk() && app::passesOf("").value().empty());
    for (const char* wrong : {"depths", "depth,", ",depth", "depth,,id", "Depth", ","}) {
        const auto refused = app::passesOf(wrong);
        QVERIFY2(!refused.isOk(), wrong);
        QVERIFY2(refused.error().message.find("colour, depth, normal") != std::string::npos, wrong);
    }
}

void TestPicturePasses::coloursAreLinear()
{
    const QString path = m_folder.filePath(QStringLiteral("colours.exr"));
    const std::vector<std::uint8_t> pixels{255, 188, 0, 7, 10, 20, 30, 128};
    QVERIFY(app::writePicture(path, pixels, {2, 1}, false).isOk());
    QCOMPARE(exrParts(path).size(), std::size_t{1});
    QCOMPARE(exrParts(path)[0], std::string("rgba: A B G R"));
    const auto red = exrValues<float>(path, 0, "R", 2, 1, Imf::FLOAT);
    const auto green = exrValues<float>(path, 0, "G", 2, 1, Imf::FLOAT);
    QCOMPARE(red[0], 1.0F);
    QVERIFY2(std::abs(green[0] - 0.5029F) < 0.001F, qPrintable(QString::number(green[0])));
    QCOMPARE(exrValues<float>(path, 0, "A", 2, 1, Imf::FLOAT)[0], 1.0F); // it says nothing
    QVERIFY(!Imf::hasWorldToCamera(Imf::MultiPartInputFile(qPrintable(path)).header(0)));
    QVERIFY(app::writePicture(path, pixels, {2, 1}, true).isOk());
    QVERIFY(std::abs(exrValues<float>(path, 0, "A", 2, 1, Imf::FLOAT)[1] - 0.502F) < 0.001F);
}

namespace {

constexpr int kSide = 64;

/// Ids far beyond what a half or a float has, in front of the camera.
app::PictureRequest tallIds()
{
    constexpr model::IndividualId kFirst = 16'777'217;
    model::IndividualRows rows = model::IndividualRows::withDefaults({kFirst});
    rows.column(model::columns::templateId)[0] = 1;
    rows.column(model::columns::height)[0] = 1.0F;
    rows.column(model::columns::girth)[0] = 1.0F;
    rows.column(model::columns::parts)[0] = 1;
    model::Population people;
    people.add(rows);
    app::PictureRequest request;
    request.frame = frameOf(people, {entryFor(makeBoxMan())});
    request.camera = model::Camera::lookingAt({0, 0.9F, 5.2F}, {0, 0.9F, 0});
    request.size = {kSide, kSide};
    return request;
}

} // namespace

void TestPicturePasses::theFileTellsWhoIsWhere()
{
    const QString path = m_folder.filePath(QStringLiteral("passes.exr"));
    model::KeyframeStore keyframes;
    auto maker = app::PictureMaker::create(keyframes);
    QVERIFY(maker.isOk());
    const app::PictureRequest request = tallIds();
    QVERIFY(maker.value()->draw(request).isOk());
    const auto passes = app::passesOf("colour,depth,normal,position,id,template");
    QVERIFY(passes.isOk());
    const auto saved = maker.value()->save(path, request, passes.value());
    QVERIFY2(saved.isOk(), saved ? "" : saved.error().message.c_str());
    const std::vector<std::string> parts{"rgba: A B G R",
                                         "depth: depth.Z",
                                         "normal: normal.X normal.Y normal.Z",
                                         "position: position.X position.Y position.Z",
                                         "id: id.X",
                                         "template: template.X"};
    QVERIFY(exrParts(path) == parts);
    const auto number = [&](int part, const char* channel, std::size_t pixel) {
        return exrValues<float>(path, part, channel, kSide, kSide, Imf::FLOAT)[pixel];
    };
    const std::size_t middle = kSide / 2 * kSide + kSide / 2;
    QCOMPARE(exrValues<std::uint32_t>(path, 4, "id.X", kSide, kSide, Imf::UINT)[middle],
             16'777'217U);
    QCOMPARE(exrValues<std::uint32_t>(path, 4, "id.X", kSide, kSide, Imf::UINT)[0], 0U);
    QCOMPARE(exrValues<std::uint32_t>(path, 5, "template.X", kSide, kSide, Imf::UINT)[middle], 1U);
    QVERIFY(std::abs(number(1, "depth.Z", middle) - 5.0F) < 0.01F);
    QVERIFY(number(1, "depth.Z", 0) > 1e9F); // the sky
    QVERIFY(std::abs(number(3, "position.Z", middle) - 0.2F) < 0.01F);
    QVERIFY(number(2, "normal.Z", middle) > 0.98F);
    const Imf::MultiPartInputFile file(qPrintable(path));
    const auto* names =
        file.header(0).findTypedAttribute<Imf::StringAttribute>("crowdbrush.templates");
    QVERIFY(names != nullptr);
    QVERIFY(names->value() == "{\"1\":\"box man\"}");
}

/// What goes on to compositing is darkened there without steps, and without burnt-out white.
void TestPicturePasses::coloursGoBeyondWhite()
{
    model::KeyframeStore keyframes;
    auto maker = app::PictureMaker::create(keyframes);
    QVERIFY(maker.isOk());
    app::PictureRequest request = tallIds();
    request.lighting.toneMap = model::ToneMap::None;
    request.lighting.exposureStops = 3.0F;
    QVERIFY(maker.value()->draw(request).isOk());
    const std::vector<std::uint8_t> bytes = maker.value()->pixels();
    const auto passes = app::passesOf("colour,depth").value();
    for (const bool hasPasses : {false, true}) {
        const QString path = m_folder.filePath(QStringLiteral("bright.exr"));
        const auto saved =
            maker.value()->save(path, request, hasPasses ? passes : app::PicturePasses());
        QVERIFY2(saved.isOk(), saved ? "" : saved.error().message.c_str());
        const auto green = exrValues<float>(path, 0, "G", kSide, kSide, Imf::FLOAT);
        QVERIFY(*std::ranges::max_element(green) > 1.5F);
        const std::set<float> steps(green.begin(), green.end());
        QVERIFY2(steps.size() > 256, qPrintable(QString::number(steps.size())));
        int differing = 0;
        for (std::size_t i = 0; i < green.size(); ++i) {
            const float shown = 255.0F * model::srgbFromLinear(std::min(green[i], 1.0F));
            differing += std::abs(shown - static_cast<float>(bytes[i * 4 + 1])) > 1.5F ? 1 : 0;
        }
        // Samples are mixed as light, not as what is seen of it.
        QVERIFY2(differing < kSide * kSide / 10, qPrintable(QString::number(differing)));
    }
    QVERIFY(maker.value()->draw(request).isOk()); // and bytes again
    QVERIFY(maker.value()->pixels() == bytes);
}

/// As programs for compositing name it; without a moment before nothing moves.
void TestPicturePasses::motionIsThere()
{
    const QString path = m_folder.filePath(QStringLiteral("motion.exr"));
    model::KeyframeStore keyframes;
    auto maker = app::PictureMaker::create(keyframes);
    QVERIFY(maker.isOk());
    app::PictureRequest request = tallIds();
    const auto passes = app::passesOf("depth,motion");
    const auto middle = [&](const char* channel) {
        const bool isSaved = maker.value()->draw(request).isOk() &&
                             maker.value()->save(path, request, passes.value()).isOk();
        return isSaved ? exrValues<float>(path, 1, channel, kSide, kSide,
                                          Imf::FLOAT)[kSide * kSide / 2 + kSide / 2]
                       : -1e9F;
    };
    QCOMPARE(middle("backward.u"), 0.0F);
    const std::vector<std::string> parts{"depth: depth.Z", "backward: backward.u backward.v"};
    QVERIFY(exrParts(path) == parts);
    model::Camera lower = request.camera;
    lower.position += glm::vec3(0.5F, -0.25F, 0.0F);
    request.earlier = render::EarlierMoment{request.frame, lower};
    const float right = middle("backward.u");
    const float up = middle("backward.v");
    QVERIFY2(right < -5.0F && right > -9.0F, qPrintable(QString::number(right)));
    QVERIFY2(std::abs(up + 0.5F * right) < 0.1F, qPrintable(QString::number(up)));
}

void TestPicturePasses::mattesHaveSmoothEdges()
{
    const QString path = m_folder.filePath(QStringLiteral("mattes.exr"));
    model::KeyframeStore keyframes;
    auto maker = app::PictureMaker::create(keyframes);
    QVERIFY(maker.isOk());
    const app::PictureRequest request = tallIds();
    QVERIFY(maker.value()->draw(request).isOk());
    const auto passes = app::passesOf("colour,cryptomatte");
    QVERIFY(maker.value()->save(path, request, passes.value()).isOk());
    const auto channel = [&](const char* name) {
        return exrValues<float>(path, 1, name, kSide, kSide, Imf::FLOAT);
    };
    const auto numbers = channel("crypto_individual00.R");
    const auto shares = channel("crypto_individual00.G");
    const std::size_t middle = kSide / 2 * kSide + kSide / 2;
    QCOMPARE(std::bit_cast<std::uint32_t>(numbers[middle]), app::matteNumber("box man.16777217"));
    QCOMPARE(shares[middle], 1.0F);
    QCOMPARE(shares[0], 0.0F);
    QCOMPARE(std::bit_cast<std::uint32_t>(channel("crypto_template00.R")[middle]),
             app::matteNumber("box man"));
    QCOMPARE(channel("crypto_individual00.A")[middle], 0.0F); // nobody else
    const auto between =
        std::ranges::count_if(shares, [](float share) { return share > 0.0F && share < 1.0F; });
    QVERIFY2(between > 30 && between < 400, qPrintable(QString::number(between)));

    const Imf::MultiPartInputFile file(qPrintable(path));
    QVERIFY(file.header(1).find("crowdbrush.templates") == file.header(1).end());
    int manifests = 0;
    const Imf::Header& header = file.header(0);
    for (auto each = header.begin(); each != header.end(); ++each) {
        const std::string name = each.name();
        if (name.starts_with("cryptomatte/") && name.ends_with("/manifest")) {
            const auto& text = dynamic_cast<const Imf::StringAttribute&>(each.attribute()).value();
            manifests += text.find("\"box man") != std::string::npos ? 1 : 0;
        }
    }
    QCOMPARE(manifests, 2);
}

/// More people in a pixel than there are ranks: nothing of their templates is lost, and templates
/// of one name are told apart.
void TestPicturePasses::manyOfAPixelKeepTheirTemplates()
{
    constexpr std::size_t kPeople = 16;
    model::Population people = makeRow(kPeople);
    std::vector<model::TemplateId> kinds(kPeople, 1);
    kinds.front() = 2;
    const std::vector<model::IndividualId> ids(people.ids().begin(), people.ids().end());
    people.setValues<model::TemplateId>(model::columns::templateId, ids, kinds);
    const auto man = makeBoxMan();
    const auto frame = frameOf(people, {entryFor(man, 1), entryFor(man, 2)});
    app::Coverage coverage;
    for (std::size_t row = 0; row < kPeople; ++row) {
        coverage.add({{1, 1}, {{}}, {{}}, {static_cast<std::int32_t>(row)}, {}}, *frame);
    }
    const app::ExrLayer layer = app::cryptomatteLayer(coverage, *frame);
    const auto valueOf = [&layer](const std::string& name) {
        const auto found = std::ranges::find(layer.channels, name, &app::ExrChannel::name);
        return std::get<std::vector<float>>(found->values).front();
    };
    QCOMPARE(std::bit_cast<std::uint32_t>(valueOf("crypto_template00.R")),
             app::matteNumber("box man#1"));
    QCOMPARE(valueOf("crypto_template00.G"), 15.0F / 16.0F);
    QCOMPARE(valueOf("crypto_template00.A"), 1.0F / 16.0F);
    QCOMPARE(valueOf("crypto_individual02.A"), 1.0F / 16.0F); // the last of six
}

/// As MurmurHash3_x86_32 is known to give them; none is a special float.
void TestPicturePasses::matteNumbersAreThoseOfOthers()
{
    QCOMPARE(app::matteNumber("hello"), 0x248BFA47U);
    QCOMPARE(app::matteNumber("hello, world"), 0x149BBB7FU);
    QCOMPARE(app::matteNumber("The quick brown fox jumps over the lazy dog"), 0x2E4FF723U);
    QVERIFY(std::isnormal(std::bit_cast<float>(app::matteNumber("")))); // whose hash is 0
    for (int i = 0; i < 2000; ++i) {
        QVERIFY(std::isnormal(std::bit_cast<float>(app::matteNumber(std::to_string(i)))));
    }
}

void TestPicturePasses::twoRunsAreTheSame()
{
    QByteArray before;
    for (int run = 0; run < 2; ++run) {
        const QString path = m_folder.filePath(QStringLiteral("run%1.exr").arg(run));
        model::KeyframeStore keyframes;
        auto maker = app::PictureMaker::create(keyframes);
        QVERIFY(maker.isOk());
        const app::PictureRequest request = tallIds();
        QVERIFY(maker.value()->draw(request).isOk());
        const auto passes = app::passesOf("colour,depth,id,cryptomatte");
        QVERIFY(maker.value()->save(path, request, passes.value()).isOk());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(run == 0 || bytes == before);
        before = bytes;
    }
}

/// For programs that read no OpenEXR: a file for each pass, of 16 bits.
void TestPicturePasses::eachCanBeAPng()
{
    const QString path = m_folder.filePath(QStringLiteral("f_0001.png"));
    model::KeyframeStore keyframes;
    auto maker = app::PictureMaker::create(keyframes);
    QVERIFY(maker.isOk());
    app::PictureRequest request = tallIds();
    request.earlier = render::EarlierMoment{request.frame, request.camera};
    const auto passes = app::passesOf("colour,depth,normal,position,motion,id,template").value();
    const auto saved = maker.value()->save(path, request, passes);
    QVERIFY2(saved.isOk(), saved ? "" : saved.error().message.c_str());
    const QStringList files = app::passFiles(path, passes);
    QCOMPARE(files.size(), 7);
    QVERIFY(app::arePassesThere(path, passes, request.size));
    QVERIFY(!app::arePassesThere(path, passes, {kSide, kSide - 1}));
    const auto pixelOf = [&](const char* pass, QPoint at) {
        const QImage image(
            m_folder.filePath(QStringLiteral("f_0001.%1.png").arg(QLatin1String(pass))));
        return image.convertToFormat(QImage::Format_RGBA64).pixelColor(at).rgba64();
    };
    const QPoint middle(kSide / 2, kSide / 2);
    QCOMPARE(QImage(path).size(), QSize(kSide, kSide));
    QVERIFY(std::abs(pixelOf("depth", middle).red() - 500) <= 1); // centimetres
    QCOMPARE(int{pixelOf("depth", {0, 0}).red()}, 65535);
    QVERIFY(pixelOf("normal", middle).blue() > 64000);
    QVERIFY(std::abs(pixelOf("position", middle).blue() - 32768 - 20) <= 1);
    QVERIFY(std::abs(pixelOf("motion", middle).red() - 32768) <= 1);
    QCOMPARE(int{pixelOf("id", middle).red()}, 256); // 16 777 217
    QCOMPARE(int{pixelOf("id", middle).green()}, 1);
    QCOMPARE(int{pixelOf("template", middle).green()}, 1);
    QCOMPARE(int{pixelOf("id", {0, 0}).green()}, 0);
    // One that is cut off is not there.
    QVERIFY(QFile::resize(files[1], QFileInfo(files[1]).size() - 3));
    QVERIFY(!app::arePassesThere(path, passes, request.size));
}

/// What a stopped run has left is gone on with only where it is whole, and of that size.
void TestPicturePasses::whatIsThereAlreadyIsLookedAt()
{
    const std::vector<std::uint8_t> pixels(32 * 16 * 4, 200);
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.webp", "a.exr"}) {
        const QString path = m_folder.filePath(QLatin1String(name));
        QVERIFY2(!app::isPictureThere(path, {32, 16}), name);
        QVERIFY(app::writePicture(path, pixels, {32, 16}).isOk());
        QVERIFY2(app::isPictureThere(path, {32, 16}), name);
        QVERIFY2(!app::isPictureThere(path, {16, 32}), name);
        QVERIFY(QFile::resize(path, QFileInfo(path).size() / 2));
        QVERIFY2(!app::isPictureThere(path, {32, 16}), name);
        QVERIFY(QFile::resize(path, 0));
        QVERIFY2(!app::isPictureThere(path, {32, 16}), name);
    }
}

void TestPicturePasses::whatCannotBeWrittenIsSaid()
{
    const std::vector<std::uint8_t> pixels(4, 255);
    const auto lost =
        app::writePicture(m_folder.filePath(QStringLiteral("no/a.exr")), pixels, {1, 1});
    QVERIFY(!lost.isOk());
    QVERIFY(lost.error().message.find("a.exr cannot be written") != std::string::npos);
    const auto none = app::roomForPasses(QStringLiteral("a.jpg"), app::passesOf("depth").value());
    QVERIFY(!none && none.error().message.find("no room for passes") != std::string::npos);
    const auto mattes =
        app::roomForPasses(QStringLiteral("a.png"), app::passesOf("depth,cryptomatte").value());
    QVERIFY(!mattes && mattes.error().message.find("\"cryptomatte\"") != std::string::npos);
    model::KeyframeStore keyframes;
    auto maker = app::PictureMaker::create(keyframes);
    QVERIFY(maker.isOk());
    app::PictureRequest request = tallIds();
    QVERIFY(maker.value()->draw(request).isOk());
    request.size = {16384, 16384};
    const auto large = maker.value()->layers(request, app::passesOf("depth").value());
    QVERIFY(!large.isOk());
    QVERIFY(large.error().message.find("16384 by 16384 pixels are too many") != std::string::npos);
    const auto empty = app::encodeExr({}, {});
    QVERIFY(!empty.isOk() && !empty.error().message.empty());
}

CROWD_TEST(TestPicturePasses)
#include "tst_PicturePasses.moc"
